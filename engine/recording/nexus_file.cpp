#include "engine/recording/nexus_file.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/recording/nexus_writer.h"
#include "engine/recording/ro_crate.h"
#include "engine/recording/staged_files.h"
#include "engine/recording/thermal_frames.h"
#include "engine/thermography/frame_picture_file.h"

#include <filesystem>
#include <fstream>

namespace bask {
namespace {

constexpr std::size_t kMarkWithin = 8192; // bytes from the start: the root's attributes are written first

/// Empty where none was recorded.
Result<std::optional<ThermalPictures>> recordedPictures(const SessionRecord& session) {
    const auto profile = thermalProfile(session.experiment, session.simulated);
    if (!profile)
        return std::optional<ThermalPictures>();
    auto times_s = thermalFrameTimes(session.path);
    if (!times_s)
        return times_s.error();
    return times_s->empty() ? std::optional<ThermalPictures>()
                            : std::optional(ThermalPictures{*profile, std::move(*times_s)});
}

/// Fills the pictures of the file at `path`, which will be `target`.
Result<void> fillPictures(const std::string& session, const ThermalPictures& pictures,
                          const std::string& path, const std::string& target, const ShareDone& told) {
    Hdf5Pictures file(path, kNexusPictures);
    std::size_t count = 0;
    Result<void> done;
    ShareCount shares(told, static_cast<double>(pictures.times_s.size()));
    const auto read = readThermalFrames(session, [&](double, const std::string& png) {
        if (!done || count == pictures.times_s.size()) // later ones of a session that is being recorded
            return;
        ++count;
        shares.add();
        const auto counts = countsOfImage(png, pictures.profile, session);
        if (counts)
            file.add(counts->counts);
        else
            done = counts.error();
    });
    if (done)
        done = read;
    return done ? file.close(target) : done;
}

} // namespace

std::string nexusName(const std::string& session) {
    return std::filesystem::path(session).stem().string() + ".nxs";
}

Result<void> checkNexus(const std::string& path) {
    std::error_code failed;
    if (!std::filesystem::exists(path, failed) || (std::filesystem::file_size(path, failed) == 0 && !failed))
        return {};
    std::ifstream file(path, std::ios::binary);
    std::string start(kMarkWithin, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (!start.starts_with("\x89HDF") || start.find("Bask ") == std::string::npos)
        return Error(MessageCode::OutputForeign, path,
                     {QT_TRANSLATE_NOOP("Parameter", "a NeXus file written by Bask")});
    return {};
}

Result<std::string> exportNexus(const SessionRecord& session, const std::string& folder,
                                const ShareDone& told, const std::string& wanted) {
    auto files = StagedFiles::into(folder);
    if (!files)
        return files.error();
    const std::string name = wanted.empty() ? nexusName(session.path) : wanted;
    const std::string target = files->target(name);
    if (auto place = checkNexus(target); !place)
        return place.error();
    const auto pictures = recordedPictures(session);
    if (!pictures)
        return pictures.error();
    const double afterNumbers = *pictures ? 0.3 : 0.8; // of the work
    std::string bytes;
    {
        Hdf5File file;
        writeNexus(file, session, name, *pictures, partOf(told, 0.0, afterNumbers));
        auto image = file.image(target);
        if (!image)
            return image.error();
        bytes = std::move(*image);
    }
    auto written = files->write(name, bytes);
    if (written && *pictures)
        written = fillPictures(session.path, **pictures, files->staged(name), target,
                               partOf(told, afterNumbers, 1.0));
    if (written)
        written = addCrate(*files, session);
    if (!written)
        return written.error();
    tellShare(told, 1.0);
    auto done = files->commit();
    return done ? Result<std::string>(done->front()) : done.error();
}

} // namespace bask
