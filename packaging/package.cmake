# What is installed, and the Debian package of it: sh packaging/make-deb.sh
include(GNUInstallDirs)
set(linux ${CMAKE_SOURCE_DIR}/packaging/linux)
set(doc ${CMAKE_INSTALL_DATADIR}/doc/bask)
set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable)
install(TARGETS bask RUNTIME)
install(TARGETS bask-draw bask-guard bask-window RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/bask) # found from bask's own place
install(TARGETS bask-pictures bask-video bask-painting bask-sleep bask-mqtt LIBRARY DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/bask)
install(FILES ${linux}/bask.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${linux}/bask.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${linux}/org.bask.Bask.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${linux}/60-bask.rules DESTINATION lib/udev/rules.d)
install(FILES ${CMAKE_SOURCE_DIR}/resources/icons/bask.svg DESTINATION ${icons}/apps)
install(FILES ${linux}/application-x-bask-session.svg ${linux}/application-x-bask-experiment.svg
              ${linux}/application-x-bask-rig.svg ${linux}/application-x-bask-recipe.svg DESTINATION ${icons}/mimetypes)
install(FILES ${linux}/copyright DESTINATION ${doc})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/examples DESTINATION ${doc})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/program_drivers ${CMAKE_SOURCE_DIR}/resources/clusters DESTINATION ${doc} PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/python DESTINATION ${CMAKE_INSTALL_DATADIR}/bask PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs/ DESTINATION ${doc} FILES_MATCHING PATTERN "*.md" PATTERN images EXCLUDE)

# Debian wants both compressed, and the same bytes each time.
foreach(pair bask.1=${CMAKE_INSTALL_MANDIR}/man1 changelog=${doc})
  string(REPLACE "=" ";" pair ${pair})
  list(GET pair 0 name)
  list(GET pair 1 folder)
  set(packed ${CMAKE_BINARY_DIR}/packaging/${name}.gz)
  add_custom_command(OUTPUT ${packed} DEPENDS ${linux}/${name}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/packaging
    COMMAND gzip -9 -n -c ${linux}/${name} > ${packed} VERBATIM)
  list(APPEND packed_files ${packed})
  install(FILES ${packed} DESTINATION ${folder})
endforeach()
add_custom_target(packed_files ALL DEPENDS ${packed_files})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME bask)
set(CPACK_PACKAGE_VENDOR "The Bask authors")
set(CPACK_PACKAGE_CONTACT "The Bask authors <bask@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# The libraries are read off the program. What Qt loads by itself is not among them: the SVG icon engine, a package of its own in
# newer Debians. The xcb platform, OpenGL and a font come with Qt's own dependencies.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6svg6 (<< 6.6) | qt6-svg-plugins")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-translations-l10n")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "fonts-noto-cjk, paraview")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "radiation-based thermal servoing")
set(CPACK_PACKAGE_DESCRIPTION
"A robot moves objects in front of a hot radiating source so that each object's
temperature reaches its target: the geometry is the actuator.
.
Bask is the window with which an operator runs such a rig: objects of any
outline, calibration with camera and markers, targets checked for feasibility
while they are typed, model-based and adaptive controllers, drivers for robots,
thermometers and heat sources, and a simulated rig.")
include(CPack)
