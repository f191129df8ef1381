#include "engine/base/message.h"

#include "engine/base/message_code.h"
#include "engine/base/notice.h"
#include "engine/base/result.h"
#include "engine/base/translated.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>

namespace bask {
namespace {

struct Entry {
    MessageCode code;
    const char* name;
    const char* text;
};

#define BASK_MESSAGE(code, text)                                                                             \
    { MessageCode::code, #code, text }

// clang-format off
constexpr Entry kMessages[]{ // not std::array, which clang deduces of no more than 256
    Entry BASK_MESSAGE(None, ""),
    Entry BASK_MESSAGE(FileNotFound, QT_TRANSLATE_NOOP("Message", "there is no such file; check the path")),
    Entry BASK_MESSAGE(FileUnreadable, QT_TRANSLATE_NOOP("Message", "the file cannot be read: %1")),
    Entry BASK_MESSAGE(FileUnwritable, QT_TRANSLATE_NOOP("Message", "the file cannot be written: %1")),
    Entry BASK_MESSAGE(FileEmpty, QT_TRANSLATE_NOOP("Message", "the file is empty")),
    Entry BASK_MESSAGE(FileTooLarge, QT_TRANSLATE_NOOP("Message", "the file has %1, more than the %2 that are read")),
    Entry BASK_MESSAGE(JsonSyntax, QT_TRANSLATE_NOOP("Message", "not one of Bask's files, or a damaged one: it is no valid JSON (%1)")),
    Entry BASK_MESSAGE(JsonUnknownKey, QT_TRANSLATE_NOOP("Message", "unknown key \"%1\"; known here: %2")),
    Entry BASK_MESSAGE(JsonMissingKey, QT_TRANSLATE_NOOP("Message", "the key \"%1\" is missing")),
    Entry BASK_MESSAGE(JsonWrongType, QT_TRANSLATE_NOOP("Message", "%1 expected, %2 found")),
    Entry BASK_MESSAGE(JsonDuplicateKey, QT_TRANSLATE_NOOP("Message", "the key \"%1\" is given twice")),
    Entry BASK_MESSAGE(JsonTooDeep, QT_TRANSLATE_NOOP("Message", "nested more than %1 levels deep")),
    Entry BASK_MESSAGE(JsonTwoSpellings, QT_TRANSLATE_NOOP("Message", "\"%1\" and \"%2\" say the same thing; give one of them")),
    Entry BASK_MESSAGE(ValueOutOfRange, QT_TRANSLATE_NOOP("Message", "%1 is out of range; allowed: %2 to %3 %4")),
    Entry BASK_MESSAGE(ValueNotPositive, QT_TRANSLATE_NOOP("Message", "%1 is not allowed; it must be greater than zero")),
    Entry BASK_MESSAGE(ValueUnknown, QT_TRANSLATE_NOOP("Message", "\"%1\" is not known; known: %2")),
    Entry BASK_MESSAGE(VersionTooNew, QT_TRANSLATE_NOOP("Message", "made by a newer version of Bask (format %1, this one knows up to %2); update Bask to open it")),
    Entry BASK_MESSAGE(OutputNotAFile, QT_TRANSLATE_NOOP("Message", "not a regular file; choose another name")),
    Entry BASK_MESSAGE(OutputIsInput, QT_TRANSLATE_NOOP("Message", "this file is also an input; choose another name for the output")),
    Entry BASK_MESSAGE(OutputTwice, QT_TRANSLATE_NOOP("Message", "another output goes there; give each its own name")),
    Entry BASK_MESSAGE(OutputForeign, QT_TRANSLATE_NOOP("Message", "a file of that name exists and is not %1; choose another name")),
    Entry BASK_MESSAGE(ExportForeign, QT_TRANSLATE_NOOP("Message", "a file of that name exists and is not an earlier export; choose another folder")),
    Entry BASK_MESSAGE(TooManyObjects, QT_TRANSLATE_NOOP("Message", "%1 objects, but the robot has only %2 free degrees of freedom; remove objects or free more axes")),
    Entry BASK_MESSAGE(MountingOverlap, QT_TRANSLATE_NOOP("Message", "%1 and %2 overlap; move one of them")),
    Entry BASK_MESSAGE(MountingFar, QT_TRANSLATE_NOOP("Message", "%1 reaches %2 cm from the end-effector's centre; the robot can carry objects within %3 cm")),
    Entry BASK_MESSAGE(MountingInLine, QT_TRANSLATE_NOOP("Message", "%1, %2 and %3 lie in a line; like temperatures for all three cannot be held together, a triangle is better")),
    Entry BASK_MESSAGE(MountingUnmoved, QT_TRANSLATE_NOOP("Message", "none of the free axes changes the view factor of %1; mount it elsewhere or free another axis")),
    Entry BASK_MESSAGE(MountingAlike, QT_TRANSLATE_NOOP("Message", "%1 and %2 have the same view factor wherever the free axes bring them, so one cannot be heated without the other; mount one elsewhere or free another axis")),
    Entry BASK_MESSAGE(MountingDependent, QT_TRANSLATE_NOOP("Message", "the free axes cannot change the view factors of %1 independently of one another; mount one elsewhere or free another axis")),
    Entry BASK_MESSAGE(MountingNoneLeft, QT_TRANSLATE_NOOP("Message", "as many objects as free axes (%1): their heating decides every movement, none is left for keeping away from limits")),
    Entry BASK_MESSAGE(NoObjects, QT_TRANSLATE_NOOP("Message", "there is no object; add at least one")),
    Entry BASK_MESSAGE(DuplicateName, QT_TRANSLATE_NOOP("Message", "the name \"%1\" is used twice; give each object its own")),
    Entry BASK_MESSAGE(NameEmpty, QT_TRANSLATE_NOOP("Message", "an object needs a name")),
    Entry BASK_MESSAGE(NameNotPlain, QT_TRANSLATE_NOOP("Message", "control characters, and spaces at either end, are not allowed in a name")),
    Entry BASK_MESSAGE(AxisTwice, QT_TRANSLATE_NOOP("Message", "the axis \"%1\" is given twice")),
    Entry BASK_MESSAGE(TargetCountWrong, QT_TRANSLATE_NOOP("Message", "%1 targets given for %2 objects")),
    Entry BASK_MESSAGE(StartOutsideWorkspace, QT_TRANSLATE_NOOP("Message", "the start's %1 is %2, outside the workspace of %3 to %4")),
    Entry BASK_MESSAGE(StartTooClose, QT_TRANSLATE_NOOP("Message", "at the start \"%1\" is %2 mm from the source plane; at least %3 mm are needed")),
    Entry BASK_MESSAGE(LimitsReversed, QT_TRANSLATE_NOOP("Message", "the lower limit %1 must be less than the upper limit %2")),
    Entry BASK_MESSAGE(NoFreeAxis, QT_TRANSLATE_NOOP("Message", "no axis of the robot is free; free at least one")),
    Entry BASK_MESSAGE(SourceTooWeak, QT_TRANSLATE_NOOP("Message", "this source cannot heat: its net power is %1 W/m2; raise its temperature or emittance, or use the gray source model")),
    Entry BASK_MESSAGE(TimesNotGrowing, QT_TRANSLATE_NOOP("Message", "the times must grow, but %1 s comes after %2 s")),
    Entry BASK_MESSAGE(SourceNotFollowed, QT_TRANSLATE_NOOP("Message", "the source has markers and is followed by the camera, which is not calibrated yet: calibrate the camera and measure where it stands on the Calibrate page, or leave the source untracked")),
    Entry BASK_MESSAGE(MotionElsewhere, QT_TRANSLATE_NOOP("Message", "the motion must begin at source.pose, where %1 is %3, not %2")),
    Entry BASK_MESSAGE(TargetsNoPose, QT_TRANSLATE_NOOP("Message", "no pose of the workspace keeps the clearance to the source; widen the workspace or lower the clearance")),
    Entry BASK_MESSAGE(TargetAboveCeiling, QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be held at %2 °C: with this source it settles at %3 °C at most, even at a view factor of 1")),
    Entry BASK_MESSAGE(TargetBelowFloor, QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be held at %2 °C: it settles at %3 °C where it does not see the source")),
    Entry BASK_MESSAGE(TargetNeedsMore, QT_TRANSLATE_NOOP("Message", "\"%1\" needs a view factor of %2; within the workspace it has at most %3")),
    Entry BASK_MESSAGE(TargetNeedsLess, QT_TRANSLATE_NOOP("Message", "\"%1\" needs a view factor of %2; within the workspace it has at least %3")),
    Entry BASK_MESSAGE(TargetsTooFarApart, QT_TRANSLATE_NOOP("Message", "\"%1\" is to be %3 K hotter than \"%2\"; with this mounting and workspace at most %4 K are possible")),
    Entry BASK_MESSAGE(TargetsTooClose, QT_TRANSLATE_NOOP("Message", "\"%1\" is to be %3 K hotter than \"%2\"; with this mounting and workspace it is at least %4 K hotter everywhere")),
    Entry BASK_MESSAGE(TargetsSurfacesApart, QT_TRANSLATE_NOOP("Message", "each target can be held by itself, but not all together: where they come nearest within the workspace, the target surfaces miss one another by %3 cm, and \"%1\" is %2 K off")),
    Entry BASK_MESSAGE(TargetsNotTogether, QT_TRANSLATE_NOOP("Message", "each target can be held by itself, but not all together: the best pose leaves \"%1\" %2 K off")),
    Entry BASK_MESSAGE(ContourTooFewPoints, QT_TRANSLATE_NOOP("Message", "only %1 points; an outline needs at least %2")),
    Entry BASK_MESSAGE(ContourNotFinite, QT_TRANSLATE_NOOP("Message", "%1 has a coordinate that is not a finite number")),
    Entry BASK_MESSAGE(ContourNotANumber, QT_TRANSLATE_NOOP("Message", "\"%1\" in line %2 is not a number")),
    Entry BASK_MESSAGE(ContourColumnMissing, QT_TRANSLATE_NOOP("Message", "line %1 has %2 column(s); an x and a y are needed")),
    Entry BASK_MESSAGE(ContourOpen, QT_TRANSLATE_NOOP("Message", "the outline is open: its ends are %1 mm apart (at most %2 mm)")),
    Entry BASK_MESSAGE(ContourCrossing, QT_TRANSLATE_NOOP("Message", "the outline crosses itself: edges %1 and %2 meet near (%3, %4) mm")),
    Entry BASK_MESSAGE(SeriesUneven, QT_TRANSLATE_NOOP("Message", "the outline crosses itself so far that it does not go round %1 % of its area exactly once; at most 1 % is taken, use other harmonics")),
    Entry BASK_MESSAGE(SeriesCrossing, QT_TRANSLATE_NOOP("Message", "the outline crosses itself near (%1, %2) mm")),
    Entry BASK_MESSAGE(ContourZeroArea, QT_TRANSLATE_NOOP("Message", "the outline encloses no area")),
    Entry BASK_MESSAGE(ContourUnitMissing, QT_TRANSLATE_NOOP("Message", "the unit of length is not known; give it (mm, cm, m or in)")),
    Entry BASK_MESSAGE(NoOutline, QT_TRANSLATE_NOOP("Message", "the file holds no outline")),
    Entry BASK_MESSAGE(XmlBroken, QT_TRANSLATE_NOOP("Message", "not readable as XML near line %2: %1")),
    Entry BASK_MESSAGE(XmlTooDeep, QT_TRANSLATE_NOOP("Message", "elements are nested or used more than %1 levels deep")),
    Entry BASK_MESSAGE(NotSvg, QT_TRANSLATE_NOOP("Message", "not an SVG drawing")),
    Entry BASK_MESSAGE(SvgSizeUnusable, QT_TRANSLATE_NOOP("Message", "the drawing's size \"%1\" cannot be used")),
    Entry BASK_MESSAGE(SvgSizeInPixels, QT_TRANSLATE_NOOP("Message", "the drawing gives its size in pixels, taken as 1/96 inch (0.2646 mm) each; check its size")),
    Entry BASK_MESSAGE(ElementsUnread, QT_TRANSLATE_NOOP("Message", "left out, since they are no outlines: %1")),
    Entry BASK_MESSAGE(DrawingTooFull, QT_TRANSLATE_NOOP("Message", "the drawing holds more than can be read; save the one outline that is needed")),
    Entry BASK_MESSAGE(DrawingTooWide, QT_TRANSLATE_NOOP("Message", "the drawing reaches farther than %1 m; check its unit")),
    Entry BASK_MESSAGE(PathTooLong, QT_TRANSLATE_NOOP("Message", "a path has more than the %1 parts that can be read; simplify it, or save the outline as DXF or CSV")),
    Entry BASK_MESSAGE(ColourUnclear, QT_TRANSLATE_NOOP("Message", "no part of the picture is clearly of this colour; set a tolerance or take another colour")),
    Entry BASK_MESSAGE(UnitNotUsed, QT_TRANSLATE_NOOP("Message", "the drawing names its unit itself (%1); the unit given is not used")),
    Entry BASK_MESSAGE(NoSilhouette, QT_TRANSLATE_NOOP("Message", "no silhouette found; the picture needs one dark object on a light ground or the reverse")),
    Entry BASK_MESSAGE(SilhouetteAtBorder, QT_TRANSLATE_NOOP("Message", "the silhouette touches the picture's border; take the picture with a margin all round")),
    Entry BASK_MESSAGE(ImageUnreadable, QT_TRANSLATE_NOOP("Message", "not a picture that can be read, or a damaged one")),
    Entry BASK_MESSAGE(ScaleNotPositive, QT_TRANSLATE_NOOP("Message", "the scale is %1 pixels per mm; it must be greater than zero")),
    Entry BASK_MESSAGE(ScaleMissing, QT_TRANSLATE_NOOP("Message", "the scale of the picture is not known; give it in pixels per mm")),
    Entry BASK_MESSAGE(HarmonicsOutOfRange, QT_TRANSLATE_NOOP("Message", "%1 harmonics; between %2 and %3 can be used")),
    Entry BASK_MESSAGE(FormatUnknown, QT_TRANSLATE_NOOP("Message", "files of type \"%1\" are not read; known: %2")),
    Entry BASK_MESSAGE(OutlineUnknown, QT_TRANSLATE_NOOP("Message", "there is no outline %1; they are numbered from 0 to %2")),
    Entry BASK_MESSAGE(OutlinesSeveral, QT_TRANSLATE_NOOP("Message", "the file holds %1 outlines; the largest is taken")),
    Entry BASK_MESSAGE(HolesLeftOut, QT_TRANSLATE_NOOP("Message", "holes left out, since they cross or touch something or are more than %2: %1")),
    Entry BASK_MESSAGE(HolesThinned, QT_TRANSLATE_NOOP("Message", "the corners of the holes were thinned from %1 to %2, within %3 mm")),
    Entry BASK_MESSAGE(FitCutsHoles, QT_TRANSLATE_NOOP("Message", "the fitted contour cuts a hole; use more harmonics")),
    Entry BASK_MESSAGE(HolesTooMany, QT_TRANSLATE_NOOP("Message", "%1 holes; there may be %2 at most")),
    Entry BASK_MESSAGE(HoleOutside, QT_TRANSLATE_NOOP("Message", "the hole does not lie wholly inside the outline")),
    Entry BASK_MESSAGE(HolesMeet, QT_TRANSLATE_NOOP("Message", "the hole meets hole %1 or lies in it, or round it")),
    Entry BASK_MESSAGE(SilhouettesAtBorder, QT_TRANSLATE_NOOP("Message", "silhouettes left out since they touch the picture's border: %1")),
    Entry BASK_MESSAGE(ScaleTwice, QT_TRANSLATE_NOOP("Message", "more than one scale is given; give pixels per mm, a known length or a marker")),
    Entry BASK_MESSAGE(MarkerNotFound, QT_TRANSLATE_NOOP("Message", "no marker of dictionary %1 is seen; it needs to lie flat in the picture with a light margin")),
    Entry BASK_MESSAGE(MarkersSeveral, QT_TRANSLATE_NOOP("Message", "%1 markers are seen; marker %2, the largest, gives the scale")),
    Entry BASK_MESSAGE(MarkerTooSmall, QT_TRANSLATE_NOOP("Message", "the marker is only %1 pixels wide; the scale is uncertain below %2")),
    Entry BASK_MESSAGE(BeyondHorizon, QT_TRANSLATE_NOOP("Message", "the outline reaches the horizon of the marker's plane; look at it more from above")),
    Entry BASK_MESSAGE(SeriesLoops, QT_TRANSLATE_NOOP("Message", "the fitted contour crosses itself; use more harmonics")),
    Entry BASK_MESSAGE(ToleranceUnreachable, QT_TRANSLATE_NOOP("Message", "the outline cannot be fitted to %1 mm without crossing itself: with %2 harmonics %3 mm are left")),
    Entry BASK_MESSAGE(DxfBinary, QT_TRANSLATE_NOOP("Message", "binary DXF is not read; save the drawing as ASCII DXF")),
    Entry BASK_MESSAGE(DxfCutOff, QT_TRANSLATE_NOOP("Message", "the drawing is cut off: its end mark (EOF) is missing")),
    Entry BASK_MESSAGE(DxfDamaged, QT_TRANSLATE_NOOP("Message", "the drawing is damaged: what line %1 says cannot be")),
    Entry BASK_MESSAGE(DxfBlockInItself, QT_TRANSLATE_NOOP("Message", "block \"%1\" contains itself")),
    Entry BASK_MESSAGE(DxfUnitless, QT_TRANSLATE_NOOP("Message", "the drawing names no known unit of length; it is taken as millimetres")),
    Entry BASK_MESSAGE(DxfHidden, QT_TRANSLATE_NOOP("Message", "%1 hidden entities were left out (layer off or frozen, invisible, or on paper)")),
    Entry BASK_MESSAGE(NumbersUnusable, QT_TRANSLATE_NOOP("Message", "\"%1\" is not the finite number or numbers that it should be")),
    Entry BASK_MESSAGE(CameraMatrixUnusable, QT_TRANSLATE_NOOP("Message", "the camera matrix cannot be used: nine numbers fx 0 cx, 0 fy cy, 0 0 1 with focal lengths above zero are needed")),
    Entry BASK_MESSAGE(DistortionUnusable, QT_TRANSLATE_NOOP("Message", "a distortion of %1 coefficients cannot be used; 4, 5 or 8 can")),
    Entry BASK_MESSAGE(CameraSizeOther, QT_TRANSLATE_NOOP("Message", "the camera was calibrated with pictures of %1 pixels, this one has %2; calibrate it at this size")),
    Entry BASK_MESSAGE(MarkerBitsUnusable, QT_TRANSLATE_NOOP("Message", "\"%1\" is not %2 digits 0 or 1")),
    Entry BASK_MESSAGE(BoardUnreadable, QT_TRANSLATE_NOOP("Message", "\"%1\" is no board; write chessboard:9x6:0.025 (inner corners, square in m) or charuco:5x7:0.04:0.02:6X6_250 (squares, square and marker in m, dictionary)")),
    Entry BASK_MESSAGE(MarkerUnreadable, QT_TRANSLATE_NOOP("Message", "\"%1\" is no marker; write marker:6X6_250:23:0.05 (dictionary, id, side in m)")),
    Entry BASK_MESSAGE(MarkerNotSmaller, QT_TRANSLATE_NOOP("Message", "a marker of %1 m does not fit into a square of %2 m")),
    Entry BASK_MESSAGE(DictionaryTooSmall, QT_TRANSLATE_NOOP("Message", "dictionary %1 has %2 markers; %3 are needed")),
    Entry BASK_MESSAGE(BoardNotSeen, QT_TRANSLATE_NOOP("Message", "no chessboard of %1 inner corners is seen; it needs to be whole in the picture, flat, with a light margin")),
    Entry BASK_MESSAGE(BoardCornersFew, QT_TRANSLATE_NOOP("Message", "only %1 corners of the board are seen; %2 that are not in one line are needed")),
    Entry BASK_MESSAGE(BoardOther, QT_TRANSLATE_NOOP("Message", "the pictures show the board %1, not %2; correct the setting")),
    Entry BASK_MESSAGE(ViewSizeOther, QT_TRANSLATE_NOOP("Message", "the picture has %1 pixels, the others %2; take all with one camera at one size")),
    Entry BASK_MESSAGE(ViewsTooFew, QT_TRANSLATE_NOOP("Message", "%1 pictures that can be used are too few; at least %2 are needed, with the board tilted in different ways")),
    Entry BASK_MESSAGE(ViewsStraightOn, QT_TRANSLATE_NOOP("Message", "in all pictures the board is seen straight on, tilted by %1 degrees at most; at least %2 are needed to tell the focal length")),
    Entry BASK_MESSAGE(ViewsParallel, QT_TRANSLATE_NOOP("Message", "in all pictures the board is held in nearly the same direction, turned by %1 degrees at most between two of them; at least %2 are needed to tell the focal length")),
    Entry BASK_MESSAGE(CalibrationFailed, QT_TRANSLATE_NOOP("Message", "no camera explains these pictures; tilt the board in different ways and check its setting")),
    Entry BASK_MESSAGE(CalibrationUncertain, QT_TRANSLATE_NOOP("Message", "the focal length is known to %1 % only; at most %2 % can be used, so add pictures with the board tilted in different ways")),
    Entry BASK_MESSAGE(CalibrationContradicts, QT_TRANSLATE_NOOP("Message", "the pictures contradict one another by %1 px; at most %2 px can be used, so check that the board is flat, its setting right and all pictures from one camera")),
    Entry BASK_MESSAGE(CalibrationCancelled, QT_TRANSLATE_NOOP("Message", "the calibration was cancelled")),
    Entry BASK_MESSAGE(CameraGood, QT_TRANSLATE_NOOP("Message", "errors at %3 m are %1 mm across the line of sight and %2 mm along it")),
    Entry BASK_MESSAGE(CameraMisfits, QT_TRANSLATE_NOOP("Message", "errors at %3 m are %1 mm across the line of sight and %2 mm along it; check that the board is flat, measured and sharp in the pictures, and leave out views that stand out")),
    Entry BASK_MESSAGE(CameraFocalUncertain, QT_TRANSLATE_NOOP("Message", "errors at %3 m are %1 mm across the line of sight and %2 mm along it; take more views with the board tilted, near the camera and at the picture's edges")),
    Entry BASK_MESSAGE(CameraUnchecked, QT_TRANSLATE_NOOP("Message", "%1 views cannot be checked against one another; take at least %2")),
    Entry BASK_MESSAGE(CoverageLeft, QT_TRANSLATE_NOOP("Message", "bring the board to the left edge of the picture")),
    Entry BASK_MESSAGE(CoverageRight, QT_TRANSLATE_NOOP("Message", "bring the board to the right edge of the picture")),
    Entry BASK_MESSAGE(CoverageTop, QT_TRANSLATE_NOOP("Message", "bring the board to the upper edge of the picture")),
    Entry BASK_MESSAGE(CoverageBottom, QT_TRANSLATE_NOOP("Message", "bring the board to the lower edge of the picture")),
    Entry BASK_MESSAGE(CoverageNearer, QT_TRANSLATE_NOOP("Message", "bring the board nearer to the camera")),
    Entry BASK_MESSAGE(CoverageTiltSideways, QT_TRANSLATE_NOOP("Message", "tilt the board more, its left or right edge towards the camera")),
    Entry BASK_MESSAGE(CoverageTiltUpDown, QT_TRANSLATE_NOOP("Message", "tilt the board more, its upper or lower edge towards the camera")),
    Entry BASK_MESSAGE(CoverageViews, QT_TRANSLATE_NOOP("Message", "%1 views of %2 that are enough")),
    Entry BASK_MESSAGE(CameraOpening, QT_TRANSLATE_NOOP("Message", "camera \"%1\" is being opened")),
    Entry BASK_MESSAGE(CameraNotOpened, QT_TRANSLATE_NOOP("Message", "camera \"%1\" cannot be opened (%2); a camera is a number, a device, a video file, a folder of pictures or an address such as rtsp://host/stream")),
    Entry BASK_MESSAGE(CameraLost, QT_TRANSLATE_NOOP("Message", "no picture from camera \"%1\" for a second (%2); check cable and power. It is taken up again as soon as it answers")),
    Entry BASK_MESSAGE(SheetTooSmall, QT_TRANSLATE_NOOP("Message", "%1 mm are needed with margins, %2 has room for %3 mm; take larger paper or a smaller pattern")),
    Entry BASK_MESSAGE(MarkerListedTwice, QT_TRANSLATE_NOOP("Message", "marker %1 is listed twice; each id is one marker")),
    Entry BASK_MESSAGE(MarkersNotSeen, QT_TRANSLATE_NOOP("Message", "none of the markers %1 was seen")),
    Entry BASK_MESSAGE(MarkerMoved, QT_TRANSLATE_NOOP("Message", "marker %1 moved by %2 px while it was looked at; camera, source and end-effector must keep still")),
    Entry BASK_MESSAGE(MarkersDisagree, QT_TRANSLATE_NOOP("Message", "no pose shows the markers %1 within %2 px of where they are seen; check their ids, sides and places")),
    Entry BASK_MESSAGE(MarkerLeftOut, QT_TRANSLATE_NOOP("Message", "marker %1 was left out: it is seen %2 px from where the others put it; check its id and place")),
    Entry BASK_MESSAGE(MarkerSideOther, QT_TRANSLATE_NOOP("Message", "marker %1 is %2 mm wide by the others, not %3 mm; measure the print")),
    Entry BASK_MESSAGE(MarkersMisfit, QT_TRANSLATE_NOOP("Message", "the markers are seen %1 px from where they fit best together; the uncertainty is widened accordingly; check their sides and places, and the camera's calibration")),
    Entry BASK_MESSAGE(PoseAmbiguous, QT_TRANSLATE_NOOP("Message", "the markers' corners allow two poses, %1 degrees apart; use more or larger markers, or tilt them against the camera")),
    Entry BASK_MESSAGE(PoseGood, QT_TRANSLATE_NOOP("Message", "the pose is good to %1 mm and %2 degrees (2 sigma)")),
    Entry BASK_MESSAGE(PoseLimited, QT_TRANSLATE_NOOP("Message", "the pose is good to %1 mm and %2 degrees only (2 sigma), and these markers before this camera allow no better than %3 mm and %4 degrees; use more or larger markers farther apart, tilt them against the camera, or bring it nearer")),
    Entry BASK_MESSAGE(PoseUncertain, QT_TRANSLATE_NOOP("Message", "the pose is good to %1 mm and %2 degrees only (2 sigma), though these markers before this camera allow %3 mm and %4 degrees; check light and focus, that all markers are seen, and their places")),
    Entry BASK_MESSAGE(HandEyeViewsFew, QT_TRANSLATE_NOOP("Message", "the end-effector's markers were seen at %1 poses of the robot; at least %2 are needed")),
    Entry BASK_MESSAGE(HandEyeNoTurn, QT_TRANSLATE_NOOP("Message", "the robot hardly turned (by %1 degrees between poses; %2 are needed): without turns the camera's place cannot be told from the markers' mounting; turn it about two axes, or measure where the markers sit on the end-effector")),
    Entry BASK_MESSAGE(HandEyeOneAxis, QT_TRANSLATE_NOOP("Message", "the robot turned about one axis only (by %1 degrees about any other; %2 are needed): along that axis the camera's place cannot be told from the markers' mounting; turn it about a second one, or measure where the markers sit on the end-effector")),
    Entry BASK_MESSAGE(HandEyeContradicts, QT_TRANSLATE_NOOP("Message", "the robot's poses and the pictures contradict one another; check that each picture was taken at its pose, that the camera kept still, and the markers' sides and places")),
    Entry BASK_MESSAGE(HandEyeViewLeftOut, QT_TRANSLATE_NOOP("Message", "pose %1 of the robot was left out: the markers are seen %2 mm and %3 degrees from where the robot has them")),
    Entry BASK_MESSAGE(FieldTooLarge, QT_TRANSLATE_NOOP("Message", "%1 samples, more than the %2 that there may be; take larger steps or a smaller range")),
    Entry BASK_MESSAGE(FieldCancelled, QT_TRANSLATE_NOOP("Message", "the sampling was cancelled")),
    Entry BASK_MESSAGE(HeldIsAxis, QT_TRANSLATE_NOOP("Message", "\"%1\" is an axis and cannot be held as well")),
    Entry BASK_MESSAGE(NotASession, QT_TRANSLATE_NOOP("Message", "not a Bask session file")),
    Entry BASK_MESSAGE(SessionDamaged, QT_TRANSLATE_NOOP("Message", "the session file is damaged: %1")),
    Entry BASK_MESSAGE(SessionBusy, QT_TRANSLATE_NOOP("Message", "the session file is in use: %1")),
    Entry BASK_MESSAGE(IdentificationTooShort, QT_TRANSLATE_NOOP("Message", "%1 readings in windows long enough are too few: at least %2 windows of %3 s are needed; record a longer run")),
    Entry BASK_MESSAGE(IdentificationUnheated, QT_TRANSLATE_NOOP("Message", "the source was never in view; record a run that heats")),
    Entry BASK_MESSAGE(IdentificationStill, QT_TRANSLATE_NOOP("Message", "the view factor hardly varied (by %1), so heating and cooling cannot be told apart; record a run that moves")),
    Entry BASK_MESSAGE(IdentificationUncertain, QT_TRANSLATE_NOOP("Message", "the record tells %1 within %2 % only; at most 25 % can be used; record a run that heats and cools more")),
    Entry BASK_MESSAGE(IdentificationNegative, QT_TRANSLATE_NOOP("Message", "%1 comes out below zero: the heat balance does not describe this record; check the sensor, the source and the environment's temperature")),
    Entry BASK_MESSAGE(ReasonNoExperiment, QT_TRANSLATE_NOOP("Message", "No experiment is loaded. Open one or make a new one.")),
    Entry BASK_MESSAGE(ReasonEstimatorFilling, QT_TRANSLATE_NOOP("Message", "The rate estimator has %1 of %2 samples. Wait a moment.")),
    Entry BASK_MESSAGE(ReasonNotAtAmbient, QT_TRANSLATE_NOOP("Message", "The objects are not at rest at the room's temperature (%1 °C), so the sensors cannot be zeroed. Let them cool, or correct the environment's temperature.")),
    Entry BASK_MESSAGE(ReasonSensorsDisagree, QT_TRANSLATE_NOOP("Message", "At rest the sensors' readings lie %1 K from their mean; at most %2 K can be zeroed. Check the sensors and their noise.")),
    Entry BASK_MESSAGE(ReasonHeldByOperator, QT_TRANSLATE_NOOP("Message", "Held by the operator. Resume or stop.")),
    Entry BASK_MESSAGE(ReasonTargetInfeasible, QT_TRANSLATE_NOOP("Message", "The targets cannot be held. See the Targets page.")),
    Entry BASK_MESSAGE(ReasonSensorStale, QT_TRANSLATE_NOOP("Message", "The sensor of \"%1\" has given nothing new for %2 s. Check its cable.")),
    Entry BASK_MESSAGE(ReasonSensorInvalid, QT_TRANSLATE_NOOP("Message", "The sensor of \"%1\" gives no plausible value: a broken wire, a loose contact, or another device than was set up. Check it.")),
    Entry BASK_MESSAGE(ReasonSourcePoseLost, QT_TRANSLATE_NOOP("Message", "The source's pose is not measured any more. Bring the source back into view.")),
    Entry BASK_MESSAGE(ReasonRobotLost, QT_TRANSLATE_NOOP("Message", "The robot does not answer: %1. Check its link, then reset.")),
    Entry BASK_MESSAGE(ReasonSourceLost, QT_TRANSLATE_NOOP("Message", "The heat source does not answer: %1. Check its link, then reset.")),
    Entry BASK_MESSAGE(ReasonEmergencyStop, QT_TRANSLATE_NOOP("Message", "STOP was pressed: the robot stands still and the heat is off. Reset when it is safe.")),
    Entry BASK_MESSAGE(ReasonRecorderFailed, QT_TRANSLATE_NOOP("Message", "The recording failed: %1. Free disk space or choose another folder, then reset.")),
    Entry BASK_MESSAGE(ReasonInternalFault, QT_TRANSLATE_NOOP("Message", "The engine met an internal fault: %1. Reset, and report it if it comes again.")),
    Entry BASK_MESSAGE(EventArmed, QT_TRANSLATE_NOOP("Message", "Armed")),
    Entry BASK_MESSAGE(EventStarted, QT_TRANSLATE_NOOP("Message", "Started")),
    Entry BASK_MESSAGE(EventHeld, QT_TRANSLATE_NOOP("Message", "Held")),
    Entry BASK_MESSAGE(EventHeldFor, QT_TRANSLATE_NOOP("Message", "Held by the engine: %1")),
    Entry BASK_MESSAGE(EventResumed, QT_TRANSLATE_NOOP("Message", "Resumed")),
    Entry BASK_MESSAGE(EventStopped, QT_TRANSLATE_NOOP("Message", "Stopped")),
    Entry BASK_MESSAGE(EventStoppedFor, QT_TRANSLATE_NOOP("Message", "Ended by the engine: %1")),
    Entry BASK_MESSAGE(EventEmergencyStop, QT_TRANSLATE_NOOP("Message", "STOP pressed")),
    Entry BASK_MESSAGE(EventCold, QT_TRANSLATE_NOOP("Message", "Everything is cold: the recording ends")),
    Entry BASK_MESSAGE(EventReset, QT_TRANSLATE_NOOP("Message", "Reset")),
    Entry BASK_MESSAGE(EventRetreat, QT_TRANSLATE_NOOP("Message", "Retreat: the heat is off, the robot takes the objects away")),
    Entry BASK_MESSAGE(EventRetreatFor, QT_TRANSLATE_NOOP("Message", "The robot takes the objects away by itself: %1")),
    Entry BASK_MESSAGE(EventSettled, QT_TRANSLATE_NOOP("Message", "All objects settled")),
    Entry BASK_MESSAGE(EventNotSettled, QT_TRANSLATE_NOOP("Message", "Not settled: %1")),
    Entry BASK_MESSAGE(EventTargetsChanged, QT_TRANSLATE_NOOP("Message", "Targets: %1")),
    Entry BASK_MESSAGE(EventGainsChanged, QT_TRANSLATE_NOOP("Message", "Controller or gains changed")),
    Entry BASK_MESSAGE(EventZeroed, QT_TRANSLATE_NOOP("Message", "Sensors zeroed at ambient")),
    Entry BASK_MESSAGE(EventCompromise, QT_TRANSLATE_NOOP("Message", "No pose in the workspace holds all targets together; going to the best compromise found, expected to end at %1 of the targets. The Targets page shows what can be held.")),
    Entry BASK_MESSAGE(EventSensorBack, QT_TRANSLATE_NOOP("Message", "The sensor of \"%1\" is back")),
    Entry BASK_MESSAGE(EventSourcePoseBack, QT_TRANSLATE_NOOP("Message", "The source's pose is measured again")),
    Entry BASK_MESSAGE(EventSensorLostTooLong, QT_TRANSLATE_NOOP("Message", "Held for more than %1 s without a reading of \"%2\": the run is ended")),
    Entry BASK_MESSAGE(EventSourceLostTooLong, QT_TRANSLATE_NOOP("Message", "Held for more than %1 s without the source's pose: the run is ended")),
    Entry BASK_MESSAGE(ActionHold, QT_TRANSLATE_NOOP("Message", "The robot stops")),
    Entry BASK_MESSAGE(ActionEndRun, QT_TRANSLATE_NOOP("Message", "The run ends, with a retreat and the heat off")),
    Entry BASK_MESSAGE(ActionHeatOff, QT_TRANSLATE_NOOP("Message", "The heat is switched off")),
    Entry BASK_MESSAGE(ActionRetreat, QT_TRANSLATE_NOOP("Message", "The robot takes the objects away from the source")),
    Entry BASK_MESSAGE(RemedyReset, QT_TRANSLATE_NOOP("Message", "Reset when the rig is safe.")),
    Entry BASK_MESSAGE(RemedyWait, QT_TRANSLATE_NOOP("Message", "Reset is possible when this is over: %1")),
    Entry BASK_MESSAGE(RemedyRetreat, QT_TRANSLATE_NOOP("Message", "Keep your hands off the robot and press Retreat: it takes the objects away from the heat.")),
    Entry BASK_MESSAGE(RemedyResume, QT_TRANSLATE_NOOP("Message", "Resume, or stop the run.")),
    Entry BASK_MESSAGE(RemedyStop, QT_TRANSLATE_NOOP("Message", "Resume is possible when this is over; Stop ends the run: %1")),
    Entry BASK_MESSAGE(CommandNotNow, QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be done in the state \"%2\"")),
    Entry BASK_MESSAGE(ShelfReasonMissing, QT_TRANSLATE_NOOP("Message", "an alarm is shelved with a reason; say why")),
    Entry BASK_MESSAGE(LimitLooser, QT_TRANSLATE_NOOP("Message", "%1: %3 instead of %2")),
    Entry BASK_MESSAGE(LimitsLoosened, QT_TRANSLATE_NOOP("Message", "this allows the real rig more than before: %1. Whether robot, source, objects and sensors bear it is for a person to say")),
    Entry BASK_MESSAGE(SessionAlreadyRunning, QT_TRANSLATE_NOOP("Message", "A run is on; stop it first")),
    Entry BASK_MESSAGE(MoveOutside, QT_TRANSLATE_NOOP("Message", "the robot cannot go there: outside of its workspace, or too near to the source")),
    Entry BASK_MESSAGE(LinkNotOpened, QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be opened: %2. Check the cable and the name of the port; Bask tries again by itself.")),
    Entry BASK_MESSAGE(LinkLost, QT_TRANSLATE_NOOP("Message", "the link to \"%1\" was lost: %2. Check the cable; Bask opens it again as soon as it is there.")),
    Entry BASK_MESSAGE(LinkStuck, QT_TRANSLATE_NOOP("Message", "\"%1\" takes no more bytes: the device does not read. Check its power and the flow control of the port.")),
    Entry BASK_MESSAGE(DeviceSilent, QT_TRANSLATE_NOOP("Message", "the device on \"%1\" has not answered for %2 s. Check its power, the cable, and the speed and unit set for it.")),
    Entry BASK_MESSAGE(DeviceOther, QT_TRANSLATE_NOOP("Message", "the device on \"%1\" is not the one that is set: it says \"%2\". Check the port and the driver.")),
    Entry BASK_MESSAGE(DeviceAnswersWrong, QT_TRANSLATE_NOOP("Message", "the device on \"%1\" answered something else than was asked: %2. It was not used. Check the settings of the port, and of the device itself.")),
    Entry BASK_MESSAGE(DeviceException, QT_TRANSLATE_NOOP("Message", "unit %2 on \"%1\" refuses the request with exception %3. Check the profile set for it.")),
    Entry BASK_MESSAGE(RobotOpening, QT_TRANSLATE_NOOP("Message", "The robot has not told its state yet. Wait a moment; if it stays so, check its power, its link and the driver set for it.")),
    Entry BASK_MESSAGE(RobotAlarm, QT_TRANSLATE_NOOP("Message", "The robot reports alarm %1: %2. See to it, clear the alarm, and home the robot if its place is not sure.")),
    Entry BASK_MESSAGE(RobotRefused, QT_TRANSLATE_NOOP("Message", "The robot refused a line with error %1: %2. See to the cause, clear the alarm, then reset.")),
    Entry BASK_MESSAGE(RobotRestarted, QT_TRANSLATE_NOOP("Message", "The robot's controller has restarted: what it was told last is lost, and its place is not sure. Home it, or confirm its place, then reset.")),
    Entry BASK_MESSAGE(RobotPlaceUnsure, QT_TRANSLATE_NOOP("Message", "The robot may not know its own place: it was not homed, or lost it in a restart or a stop. Home it, or confirm its place.")),
    Entry BASK_MESSAGE(RobotHeld, QT_TRANSLATE_NOOP("Message", "The robot is held at its own panel (%1). Release it there, then clear the alarm.")),
    Entry BASK_MESSAGE(RobotDisabled, QT_TRANSLATE_NOOP("Message", "The robot is switched off at its own controller. Enable it, then clear the alarm.")),
    Entry BASK_MESSAGE(RobotCannotHome, QT_TRANSLATE_NOOP("Message", "this robot has no homing")),
    Entry BASK_MESSAGE(RobotStepOutside, QT_TRANSLATE_NOOP("Message", "a step of the robot would leave its workspace or come too near to the source; it was not sent")),
    Entry BASK_MESSAGE(RobotElsewhere, QT_TRANSLATE_NOOP("Message", "The robot is %1 mm from where its steps should have brought it, more than %2 mm. It may have been pushed or have lost steps: check it, home it, then reset.")),
    Entry BASK_MESSAGE(RobotSlow, QT_TRANSLATE_NOOP("Message", "The robot has told nothing, and taken nothing, for %1 s; the heat is off. Check its controller, then reset.")),
    Entry BASK_MESSAGE(RobotDoesNotMove, QT_TRANSLATE_NOOP("Message", "The robot was told to take the objects away and does not move; %1 cm are left. The heat is off. Take them away by hand, mind the heat; check the robot's power and its drives.")),
    Entry BASK_MESSAGE(AxesNone, QT_TRANSLATE_NOOP("Message", "the robot has no axis")),
    Entry BASK_MESSAGE(AxisLetterUnknown, QT_TRANSLATE_NOOP("Message", "\"%1\" is not an axis; axes are X, Y, Z, A, B, C and R")),
    Entry BASK_MESSAGE(AxisLetterTwice, QT_TRANSLATE_NOOP("Message", "the axis %1 is given twice")),
    Entry BASK_MESSAGE(AxisCoordinateTwice, QT_TRANSLATE_NOOP("Message", "two axes drive %1")),
    Entry BASK_MESSAGE(AxisMissing, QT_TRANSLATE_NOOP("Message", "%1 is free, but no axis of the robot drives it")),
    Entry BASK_MESSAGE(ChannelCountWrong, QT_TRANSLATE_NOOP("Message", "%1 channels for %2 objects; give each object one")),
    Entry BASK_MESSAGE(ChannelTwice, QT_TRANSLATE_NOOP("Message", "two objects have channel %1; give each its own")),
    Entry BASK_MESSAGE(PortTwice, QT_TRANSLATE_NOOP("Message", "two devices are on \"%1\"; only Modbus devices of different units and the same line settings can share a port")),
    Entry BASK_MESSAGE(ProfileOther, QT_TRANSLATE_NOOP("Message", "the profile \"%1\" is that of another kind of device")),
    Entry BASK_MESSAGE(FaultOnRealRig, QT_TRANSLATE_NOOP("Message", "faults can be simulated on the simulated rig only")),
    Entry BASK_MESSAGE(RigMissing, QT_TRANSLATE_NOOP("Message", "the experiment has no rig of its own (\"rig\"), only the simulated one")),
    Entry BASK_MESSAGE(RigIncomplete, QT_TRANSLATE_NOOP("Message", "the rig has no %1; set one, or use the simulated rig")),
    Entry BASK_MESSAGE(SimulatedPortTaken, QT_TRANSLATE_NOOP("Message", "\"%1\" exists and is not a link; choose another path")),
    Entry BASK_MESSAGE(SafetyStartUp, QT_TRANSLATE_NOOP("Message", "Bask has just connected to the rig. Check it, then reset.")),
    Entry BASK_MESSAGE(SafetyObjectWarm, QT_TRANSLATE_NOOP("Message", "\"%1\" has %2 °C, above its warning limit of %3 °C. Let it cool: Stop or Retreat takes it away. Check its target and its limits.")),
    Entry BASK_MESSAGE(SafetyObjectHot, QT_TRANSLATE_NOOP("Message", "\"%1\" has %2 °C, above its limit of %3 °C. It is taken away and the heat is off. Check the object and its sensor; reset once it has cooled.")),
    Entry BASK_MESSAGE(SafetySourceHot, QT_TRANSLATE_NOOP("Message", "The source has %1 °C, above its limit of %2 °C. The objects are taken away and the heat is off. Check its controller and sensor; reset once it has cooled.")),
    Entry BASK_MESSAGE(SafetySensorOpen, QT_TRANSLATE_NOOP("Message", "The sensor of \"%1\" is open: a wire or the plug is off. Mend it.")),
    Entry BASK_MESSAGE(SafetySensorShort, QT_TRANSLATE_NOOP("Message", "The sensor of \"%1\" is shorted: look at its wires and plug. Mend it.")),
    Entry BASK_MESSAGE(SafetySensorFrozen, QT_TRANSLATE_NOOP("Message", "The sensor of \"%1\" has given the very same value for %2 s: it, or its device, has stopped. Check it.")),
    Entry BASK_MESSAGE(SafetySensorJump, QT_TRANSLATE_NOOP("Message", "The sensor of \"%1\" jumped by %2 K/s, more than the %3 K/s that heat can do. Look for a loose contact, and whether it came off. It is believed again when it agrees with the heat, or when it is confirmed.")),
    Entry BASK_MESSAGE(SafetySensorsApart, QT_TRANSLATE_NOOP("Message", "\"%1\" and \"%2\" are far from the source but %3 K apart, more than %4 K. One sensor is wrong or off its object: check both.")),
    Entry BASK_MESSAGE(SafetyNotWarming, QT_TRANSLATE_NOOP("Message", "The temperature of \"%1\" should have changed by %2 K in %3 s and has not: its sensor may be off, the object gone, or the source not where it is believed. The heat is off. Check, then reset.")),
    Entry BASK_MESSAGE(SafetySourceNotHeating, QT_TRANSLATE_NOOP("Message", "The source is at %1 °C and has not come nearer to %2 °C for %3 s. Check that it is switched on and its sensor in place, then reset.")),
    Entry BASK_MESSAGE(SafetySourceHeatsUnasked, QT_TRANSLATE_NOOP("Message", "The source warmed by %1 K in %2 s though its heat is off, more than the %3 K it may: its relay may be stuck, or somebody heats it at its panel. Switch it off at its mains, then reset.")),
    Entry BASK_MESSAGE(SafetySetPointOther, QT_TRANSLATE_NOOP("Message", "The source was set to %1 °C and reads back %2 °C. Check its own panel and limits, then reset.")),
    Entry BASK_MESSAGE(SafetyLoopLate, QT_TRANSLATE_NOOP("Message", "The control loop was held up for %1 s, more than the %2 s it may be; the robot stood. Close other programs on this computer.")),
    Entry BASK_MESSAGE(SafetyDiskLow, QT_TRANSLATE_NOOP("Message", "Only %1 MB of disk space are left; a recording needs %2 MB. Free some, then arm again.")),
    Entry BASK_MESSAGE(SafetySourceSilent, QT_TRANSLATE_NOOP("Message", "The heat source has told no temperature for %1 s. Check its sensor and its link, then reset.")),
    Entry BASK_MESSAGE(EventFault, QT_TRANSLATE_NOOP("Message", "simulated fault: %1")),
    Entry BASK_MESSAGE(EventAlarmOver, QT_TRANSLATE_NOOP("Message", "over: %1")),
    Entry BASK_MESSAGE(SafetyHeatNotOff, QT_TRANSLATE_NOOP("Message", "The heat source did not take the order to switch off. Switch it off at its mains. It says: %1")),
    Entry BASK_MESSAGE(SafetyHeatByHand, QT_TRANSLATE_NOOP("Message", "The source is heated by hand, so Bask cannot switch it off: it has %1 °C. Switch it off yourself, and keep the objects away from it.")),
    Entry BASK_MESSAGE(TargetAboveWarning, QT_TRANSLATE_NOOP("Message", "The target of \"%1\", %2 °C, is above its warning limit of %3 °C, where every run holds. Lower the target, or raise the limit if object and sensor bear it.")),
    Entry BASK_MESSAGE(SafetySourceNotCooling, QT_TRANSLATE_NOOP("Message", "The source is still at %1 °C, %2 s after its heat was switched off. Switch it off at its mains, then reset.")),
    Entry BASK_MESSAGE(SafetyNoWatchdog, QT_TRANSLATE_NOOP("Message", "The heat source has no watchdog: if this computer stops, it stays hot. Do not leave it alone.")),
    Entry BASK_MESSAGE(SafetySourceStopped, QT_TRANSLATE_NOOP("Message", "The heat source was stopped at its own panel or by its own protection; Bask keeps it off. See why, then reset.")),
    Entry BASK_MESSAGE(SourceUnwatched, QT_TRANSLATE_NOOP("Message", "with the profile \"%1\" the source has no watchdog: it stays hot when Bask or the computer dies. Take a controller that has one, or allow it with \"unattended_heat\": true.")),
    Entry BASK_MESSAGE(EventObjectFault, QT_TRANSLATE_NOOP("Message", "simulated fault of \"%2\": %1")),
    Entry BASK_MESSAGE(RecipeWithoutRun, QT_TRANSLATE_NOOP("Message", "a recipe needs at least one step that runs an experiment")),
    Entry BASK_MESSAGE(EventHeldTooLong, QT_TRANSLATE_NOOP("Message", "Held for more than %1 s without a reading: the run is ended")),
    Entry BASK_MESSAGE(HeaterGuardMissing, QT_TRANSLATE_NOOP("Message", "No heat without the guard process, which switches the heater off if Bask dies; it cannot be started: %1. Install Bask again.")),
    Entry BASK_MESSAGE(HeaterGuardTookOver, QT_TRANSLATE_NOOP("Message", "The guard process has taken the heater over and switches it off: %1. Its log tells what it did. See why, then reset.")),
    Entry BASK_MESSAGE(HeaterGuardLost, QT_TRANSLATE_NOOP("Message", "The heater's guard process has ended; Bask has taken the port back and switches the heat off. Reset starts a new guard.")),
    Entry BASK_MESSAGE(ReasonSensorDistrusted, QT_TRANSLATE_NOOP("Message", "The sensor of \"%1\" reads %2 °C, but by the heat since it was right its object has %3 to %4 °C. Look whether it is on its object, then confirm it.")),
    Entry BASK_MESSAGE(SafetySensorQuiet, QT_TRANSLATE_NOOP("Message", "The sensor of \"%1\" has given the very same value for %2 s, without its usual noise: it may have stopped. Watch whether it follows, or confirm it.")),
    Entry BASK_MESSAGE(SafetyBeyondHeat, QT_TRANSLATE_NOOP("Message", "The temperature of \"%1\" has changed by %2 K in %3 s, which no heat or loss explains: its sensor may be off, or something touches the object. The heat is off. Check, then reset.")),
    Entry BASK_MESSAGE(AlarmsElsewhere, QT_TRANSLATE_NOOP("Message", "Another Bask runs with the same settings. The alarms of this one are kept in %1.")),
    Entry BASK_MESSAGE(EventSensorConfirmed, QT_TRANSLATE_NOOP("Message", "The sensor of \"%1\" is confirmed at %2 °C")),
    Entry BASK_MESSAGE(SafetySourceCold, QT_TRANSLATE_NOOP("Message", "The heat source tells %1 °C, more than %3 K below the room's %2 °C: it may count in another unit (°C, °F) than its profile says, or its sensor is wrong. It is not heated. Set both alike, then reset.")),
    Entry BASK_MESSAGE(SafetySourceUnit, QT_TRANSLATE_NOOP("Message", "The heat source tells %1 °C where it should be %2 °C, which is the same number in °F: it counts in another unit than its profile says. It is not heated. Set both alike, then reset.")),
    Entry BASK_MESSAGE(SafetySuspended, QT_TRANSLATE_NOOP("Message", "The computer was suspended for %1 s while the source was hot or the robot moved: nobody knows what happened meanwhile. The heat is off. Look at the rig, then reset.")),
    Entry BASK_MESSAGE(EventSuspended, QT_TRANSLATE_NOOP("Message", "The computer was suspended for %1 s")),
    Entry BASK_MESSAGE(EventMaySleep, QT_TRANSLATE_NOOP("Message", "This computer cannot be kept awake while heat is on (%1): switch off its standby, and keep its lid open")),
    Entry BASK_MESSAGE(EventDeviceAccepted, QT_TRANSLATE_NOOP("Message", "The device that answers at %1 is the right one from now on")),
    Entry BASK_MESSAGE(DeviceExchanged, QT_TRANSLATE_NOOP("Message", "Another device than before answers at %1: it was \"%2\" and is \"%3\". Nothing is written to it. Put the plugs right, or say on the Rig page that this is the one.")),
    Entry BASK_MESSAGE(HeatLeftUnknown, QT_TRANSLATE_NOOP("Message", "The heat of the real rig (%1) is not known to be off, and Bask does not watch it any more. Look at the plate; switch it off at its mains.")),
    Entry BASK_MESSAGE(ReasonSensorDoubted, QT_TRANSLATE_NOOP("Message", "The sensor of \"%1\" reads %2 °C and did not follow its object's heat. Look whether it is on its object, then confirm it.")),
    Entry BASK_MESSAGE(EventRecordEnded, QT_TRANSLATE_NOOP("Message", "The recording of the fault has ended, since the experiment was changed or another one was opened.")),
};
// clang-format on

const Entry& entry(MessageCode code) {
    const auto it = std::ranges::find(kMessages, code, &Entry::code);
    return it == std::end(kMessages) ? kMessages[0] : *it;
}

} // namespace

bool isAboutAnother(MessageCode code) {
    switch (code) {
    case MessageCode::EventAlarmOver:
    case MessageCode::EventHeldFor:
    case MessageCode::EventStoppedFor:
    case MessageCode::EventRetreatFor:
    case MessageCode::RemedyWait:
    case MessageCode::RemedyStop:
        return true;
    default:
        return false;
    }
}

const char* messageTemplate(MessageCode code) {
    return entry(code).text;
}

const char* messageName(MessageCode code) {
    return entry(code).name;
}

MessageCode messageCodeFromName(const std::string& name) {
    const auto it = std::ranges::find_if(kMessages, [&](const Entry& e) { return name == e.name; });
    return it == std::end(kMessages) ? MessageCode::None : it->code;
}

// By what happens if nobody does anything, and how soon: EEMUA 191.
int alarmPriority(MessageCode code) {
    switch (code) {
    case MessageCode::ReasonRobotLost:
    case MessageCode::ReasonSourceLost:
    case MessageCode::ReasonInternalFault:
    case MessageCode::LinkNotOpened:
    case MessageCode::LinkLost:
    case MessageCode::LinkStuck:
    case MessageCode::DeviceSilent:
    case MessageCode::DeviceOther:
    case MessageCode::DeviceExchanged:
    case MessageCode::DeviceException:
    case MessageCode::RobotOpening:
    case MessageCode::RobotDoesNotMove:
    case MessageCode::SafetyObjectHot:
    case MessageCode::SafetySourceHot:
    case MessageCode::SafetySourceHeatsUnasked:
    case MessageCode::SafetySourceNotCooling:
    case MessageCode::SafetyHeatNotOff:
    case MessageCode::SafetyHeatByHand:
    case MessageCode::HeaterGuardMissing:
    case MessageCode::HeaterGuardTookOver:
    case MessageCode::HeaterGuardLost:
    case MessageCode::HeatLeftUnknown:
        return 1;
    case MessageCode::ReasonEmergencyStop:
    case MessageCode::EventEmergencyStop:
    case MessageCode::DeviceAnswersWrong:
    case MessageCode::RobotAlarm:
    case MessageCode::RobotRefused:
    case MessageCode::RobotRestarted:
    case MessageCode::RobotPlaceUnsure:
    case MessageCode::RobotHeld:
    case MessageCode::RobotDisabled:
    case MessageCode::RobotStepOutside:
    case MessageCode::RobotElsewhere:
    case MessageCode::RobotSlow:
    case MessageCode::SafetyObjectWarm:
    case MessageCode::SafetySourceSilent:
    case MessageCode::SafetySourceCold:
    case MessageCode::SafetySourceUnit:
    case MessageCode::SafetySuspended:
    case MessageCode::SafetyDiskLow:
        return 2;
    case MessageCode::ReasonSensorStale:
    case MessageCode::ReasonSensorInvalid:
    case MessageCode::ReasonSourcePoseLost:
    case MessageCode::ReasonRecorderFailed:
    case MessageCode::SafetyStartUp:
    case MessageCode::SafetySensorOpen:
    case MessageCode::SafetySensorShort:
    case MessageCode::SafetySensorFrozen:
    case MessageCode::SafetySensorJump:
    case MessageCode::SafetyNotWarming:
    case MessageCode::SafetyBeyondHeat:
    case MessageCode::SafetySourceNotHeating:
    case MessageCode::SafetySetPointOther:
    case MessageCode::SafetySourceStopped:
        return 3;
    default:
        return isNotice(code) ? 3 : 0;
    }
}

bool isNotice(MessageCode code) {
    switch (code) {
    case MessageCode::SafetySensorsApart:
    case MessageCode::SafetyNoWatchdog:
    case MessageCode::SafetyLoopLate:
    case MessageCode::SafetySensorQuiet:
    case MessageCode::EventCompromise:
    case MessageCode::EventNotSettled:
    case MessageCode::TargetAboveCeiling:
    case MessageCode::TargetBelowFloor:
    case MessageCode::TargetNeedsMore:
    case MessageCode::TargetNeedsLess:
    case MessageCode::TargetsTooFarApart:
    case MessageCode::TargetsTooClose:
    case MessageCode::TargetsSurfacesApart:
    case MessageCode::TargetsNoPose:
        return true;
    default:
        return false;
    }
}

std::optional<Message> messageWithin(const Message& message) {
    if (!isAboutAnother(message.code) || message.args.empty())
        return std::nullopt;
    const MessageCode code = messageCodeFromName(message.args.front());
    if (code == MessageCode::None || isAboutAnother(code))
        return std::nullopt;
    return Message{code, {message.args.begin() + 1, message.args.end()}};
}

Message messageAbout(MessageCode code, const Message& about) {
    Message out{code, {messageName(about.code)}};
    out.args.insert(out.args.end(), about.args.begin(), about.args.end());
    return out;
}

std::string describe(const Message& message) {
    if (const auto within = messageWithin(message))
        return describe(Message{message.code, {describe(*within)}});
    std::string out;
    for (const char* p = messageTemplate(message.code); *p != '\0'; ++p) {
        if (*p == '%' && p[1] >= '1' && p[1] <= '9') {
            const auto index = static_cast<std::size_t>(p[1] - '1');
            if (index < message.args.size())
                out += message.args[index];
            ++p;
        } else {
            out += *p;
        }
    }
    out.erase(out.find_last_not_of(' ') + 1); // a unit may be empty
    return out;
}

std::string describe(const Error& error) {
    return error.where.empty() ? describe(error.message) : error.where + ": " + describe(error.message);
}

std::string formatNumber(double value, int digits) {
    std::array<char, 40> buffer{}; // not printf: its decimal point is that of the computer's language
    const auto [end, failed] =
        std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::general, digits);
    return {buffer.begin(), end};
}

} // namespace bask
