#pragma once
// The names of everything that Bask says: a code a sentence, whose English is in message.cpp.

namespace bask {

/// Names of sentences. The table in message.cpp has one English template ("%1", "%2" ...) for each.
enum class MessageCode : int {
    None,
    // Files and JSON
    FileNotFound,     ///< no args
    FileUnreadable,   ///< %1 reason
    FileUnwritable,   ///< %1 reason
    FileEmpty,        ///< no args
    FileTooLarge,     ///< %1 size, %2 limit
    JsonSyntax,       ///< %1 parser's words
    JsonUnknownKey,   ///< %1 key, %2 known keys
    JsonMissingKey,   ///< %1 key
    JsonWrongType,    ///< %1 expected, %2 found
    JsonDuplicateKey, ///< %1 key
    JsonTooDeep,      ///< %1 levels allowed
    JsonTwoSpellings, ///< %1, %2 keys
    ValueOutOfRange,  ///< %1 value, %2 least, %3 most, %4 unit
    ValueNotPositive, ///< %1 value
    ValueUnknown,     ///< %1 value, %2 known values
    VersionTooNew,    ///< %1 found, %2 newest known
    OutputNotAFile,   ///< no args
    OutputIsInput,    ///< no args
    OutputTwice,      ///< no args
    OutputForeign,    ///< %1 what may be replaced
    ExportForeign,    ///< no args
    // Experiment
    TooManyObjects,        ///< %1 objects, %2 degrees of freedom
    MountingOverlap,       ///< %1, %2 objects
    MountingFar,           ///< %1 object, %2 cm, %3 cm most
    MountingInLine,        ///< %1, %2, %3 objects
    MountingUnmoved,       ///< %1 object
    MountingAlike,         ///< %1, %2 objects
    MountingDependent,     ///< %1 objects, with commas
    MountingNoneLeft,      ///< %1 objects and free axes
    NoObjects,             ///< no args
    DuplicateName,         ///< %1 name
    NameEmpty,             ///< no args
    NameNotPlain,          ///< no args
    AxisTwice,             ///< %1 axis
    TargetCountWrong,      ///< %1 given, %2 objects
    StartOutsideWorkspace, ///< %1 coordinate, %2 value, %3 least, %4 most
    StartTooClose,         ///< %1 object, %2 distance mm, %3 clearance mm
    LimitsReversed,        ///< %1 lower, %2 upper
    NoFreeAxis,            ///< no args
    SourceTooWeak,         ///< %1 net emissive power W/m2
    TimesNotGrowing,       ///< %1 time s, %2 the one before
    SourceNotFollowed,     ///< no args
    MotionElsewhere,       ///< %1 coordinate, %2 value, %3 of source.pose
    // Why targets cannot be held together
    TargetsNoPose,        ///< no args
    TargetAboveCeiling,   ///< %1 object, %2 target degC, %3 degC at F = 1
    TargetBelowFloor,     ///< %1 object, %2 target degC, %3 degC at F = 0
    TargetNeedsMore,      ///< %1 object, %2 view factor needed, %3 largest
    TargetNeedsLess,      ///< %1 object, %2 view factor needed, %3 least
    TargetsTooFarApart,   ///< %1 hotter, %2 colder object, %3 K wanted, %4 K most
    TargetsTooClose,      ///< %1 hotter, %2 colder object, %3 K wanted, %4 K least
    TargetsSurfacesApart, ///< %1 object with the largest error, %2 its K, %3 gap cm
    TargetsNotTogether,   ///< %1 object with the largest error, %2 its K
    // Contours
    ContourTooFewPoints,  ///< %1 points, %2 least
    ContourNotFinite,     ///< %1 line or point
    ContourNotANumber,    ///< %1 text, in line %2
    ContourColumnMissing, ///< %1 line, %2 columns found
    ContourOpen,          ///< %1 gap mm, %2 allowed mm
    ContourCrossing,      ///< %1, %2 edge numbers, %3 x mm, %4 y mm
    SeriesUneven,         ///< %1 percent
    SeriesCrossing,       ///< %1 x mm, %2 y mm
    ContourZeroArea,      ///< no args
    ContourUnitMissing,   ///< no args
    NoOutline,            ///< no args
    XmlBroken,            ///< %1 parser's words, %2 line
    XmlTooDeep,           ///< %1 levels allowed
    NotSvg,               ///< no args
    SvgSizeUnusable,      ///< %1 width, height or view box
    SvgSizeInPixels,      ///< no args
    ElementsUnread,       ///< %1 names
    DrawingTooFull,       ///< no args
    DrawingTooWide,       ///< %1 m allowed
    PathTooLong,          ///< %1 parts allowed
    ColourUnclear,        ///< no args
    UnitNotUsed,          ///< %1 the drawing's
    NoSilhouette,         ///< no args
    SilhouetteAtBorder,   ///< no args
    ImageUnreadable,      ///< no args
    ScaleNotPositive,     ///< %1 value
    ScaleMissing,         ///< no args
    HarmonicsOutOfRange,  ///< %1 value, %2 least, %3 most
    FormatUnknown,        ///< %1 extension, %2 known
    OutlineUnknown,       ///< %1 index, %2 last index
    OutlinesSeveral,      ///< %1 outlines
    HolesLeftOut,         ///< %1 holes, %2 most
    HolesThinned,         ///< from %1 to %2 corners, within %3 mm
    FitCutsHoles,         ///< no args
    HolesTooMany,         ///< %1 holes, %2 most
    HoleOutside,          ///< no args
    HolesMeet,            ///< %1 index of the other
    SilhouettesAtBorder,  ///< %1 silhouettes
    ScaleTwice,           ///< no args
    MarkerNotFound,       ///< %1 dictionary
    MarkersSeveral,       ///< %1 markers, %2 id
    MarkerTooSmall,       ///< %1 px, %2 least
    BeyondHorizon,        ///< no args
    SeriesLoops,          ///< no args
    ToleranceUnreachable, ///< %1 tolerance mm, %2 harmonics, %3 distance mm
    DxfBinary,            ///< no args
    DxfCutOff,            ///< no args
    DxfDamaged,           ///< %1 line
    DxfBlockInItself,     ///< %1 block
    DxfUnitless,          ///< no args
    DxfHidden,            ///< %1 count
    // Cameras, calibration boards, markers
    NumbersUnusable,        ///< %1 key
    CameraMatrixUnusable,   ///< no args
    DistortionUnusable,     ///< %1 coefficients
    CameraSizeOther,        ///< %1 calibrated, %2 picture
    MarkerBitsUnusable,     ///< %1 key, %2 bits
    BoardUnreadable,        ///< %1 text
    MarkerUnreadable,       ///< %1 text
    MarkerNotSmaller,       ///< %1 marker m, %2 square m
    DictionaryTooSmall,     ///< %1 dictionary, %2 markers, %3 needed
    BoardNotSeen,           ///< %1 inner corners
    BoardCornersFew,        ///< %1 corners, %2 needed
    BoardOther,             ///< %1 board seen, %2 board set
    ViewSizeOther,          ///< %1 pixels, %2 of the others
    ViewsTooFew,            ///< %1 views, %2 needed
    ViewsStraightOn,        ///< %1 degrees, %2 needed
    ViewsParallel,          ///< %1 degrees, %2 needed
    CalibrationFailed,      ///< no args
    CalibrationUncertain,   ///< %1 percent, %2 allowed
    CalibrationContradicts, ///< %1 px, %2 allowed
    CalibrationCancelled,   ///< no args
    CameraGood,             ///< %1 mm across, %2 mm along, %3 m away
    CameraMisfits,          ///< %1 mm across, %2 mm along, %3 m away
    CameraFocalUncertain,   ///< %1 mm across, %2 mm along, %3 m away
    CameraUnchecked,        ///< %1 views, %2 needed
    CoverageLeft,           ///< no args
    CoverageRight,          ///< no args
    CoverageTop,            ///< no args
    CoverageBottom,         ///< no args
    CoverageNearer,         ///< no args
    CoverageTiltSideways,   ///< no args
    CoverageTiltUpDown,     ///< no args
    CoverageViews,          ///< %1 views, %2 enough
    CameraOpening,          ///< %1 camera
    CameraNotOpened,        ///< %1 camera, %2 words
    CameraLost,             ///< %1 camera, %2 words
    SheetTooSmall,          ///< %1 mm needed, %2 paper, %3 mm of room
    // Rig calibration
    MarkerListedTwice,  ///< %1 id
    MarkersNotSeen,     ///< %1 ids
    MarkerMoved,        ///< %1 id, %2 px
    MarkersDisagree,    ///< %1 ids, %2 px
    MarkerLeftOut,      ///< %1 id, %2 px
    MarkerSideOther,    ///< %1 id, %2 mm by the others, %3 mm set
    MarkersMisfit,      ///< %1 px
    PoseAmbiguous,      ///< %1 degrees between the two
    PoseGood,           ///< %1 mm, %2 degrees
    PoseLimited,        ///< %1 mm, %2 degrees, %3 mm possible, %4 degrees possible
    PoseUncertain,      ///< %1 mm, %2 degrees, %3 mm possible, %4 degrees possible
    HandEyeViewsFew,    ///< %1 poses, %2 needed
    HandEyeNoTurn,      ///< %1 degrees, %2 needed
    HandEyeOneAxis,     ///< %1 degrees, %2 needed
    HandEyeContradicts, ///< no args
    HandEyeViewLeftOut, ///< %1 number of the pose, %2 mm, %3 degrees
    // View factor
    FieldTooLarge,  ///< %1 samples, %2 most
    FieldCancelled, ///< no args
    HeldIsAxis,     ///< %1 coordinate
    // Session file
    NotASession,    ///< no args
    SessionDamaged, ///< %1 database's words
    SessionBusy,    ///< %1 words
    // Identification of rates
    IdentificationTooShort,  ///< %1 readings, %2 windows needed, %3 their length s
    IdentificationUnheated,  ///< no args
    IdentificationStill,     ///< %1 variation of the view factor
    IdentificationUncertain, ///< %1 rate, %2 its standard error in percent
    IdentificationNegative,  ///< %1 rate
    // Rig: reasons for not being ready, faults
    ReasonNoExperiment,     ///< no args
    ReasonEstimatorFilling, ///< %1 samples so far, %2 needed
    ReasonNotAtAmbient,     ///< %1 degC expected
    ReasonSensorsDisagree,  ///< %1 K apart at rest, %2 K allowed
    ReasonHeldByOperator,
    ReasonTargetInfeasible, ///< no args
    ReasonSensorStale,      ///< %1 object, %2 age s
    ReasonSensorInvalid,    ///< %1 object
    ReasonSourcePoseLost,   ///< no args
    ReasonRobotLost,        ///< %1 words
    ReasonSourceLost,       ///< %1 words
    ReasonEmergencyStop,    ///< no args
    ReasonRecorderFailed,   ///< %1 words
    ReasonInternalFault,    ///< %1 words
    // Events of a run
    EventArmed,
    EventStarted,
    EventHeld,
    EventHeldFor, ///< name of a message, then its arguments
    EventResumed,
    EventStopped,
    EventStoppedFor, ///< name of a message, then its arguments
    EventEmergencyStop,
    EventCold, ///< no args
    EventReset,
    EventRetreat,    ///< no args
    EventRetreatFor, ///< name of a message, then its arguments
    EventSettled,
    EventNotSettled, ///< %1 objects' names
    EventTargetsChanged,
    EventGainsChanged,
    EventZeroed,
    EventCompromise, ///< %1 words: objects with residuals
    EventSensorBack, ///< %1 object
    EventSourcePoseBack,
    EventSensorLostTooLong, ///< %1 s, %2 object
    EventSourceLostTooLong, ///< %1 s
    // What the engine will do by itself, and what a person can do now
    ActionHold,
    ActionEndRun,
    ActionHeatOff,
    ActionRetreat,
    RemedyReset,
    RemedyWait,
    RemedyRetreat,
    RemedyResume,
    RemedyStop,
    // Commands refused
    CommandNotNow,      ///< %1 command, %2 state
    ShelfReasonMissing, ///< no args
    LimitLooser,        ///< %1 name, %2 before, %3 after
    LimitsLoosened,     ///< %1 limits, with semicolons
    SessionAlreadyRunning,
    MoveOutside, ///< no args
    // Links and devices
    LinkNotOpened,       ///< %1 port, %2 words
    LinkLost,            ///< %1 port, %2 words
    LinkStuck,           ///< %1 port
    DeviceSilent,        ///< %1 port, %2 s
    DeviceOther,         ///< %1 port, %2 what it said
    DeviceAnswersWrong,  ///< %1 port, %2 words
    DeviceException,     ///< %1 port, %2 unit, %3 exception
    RobotOpening,        ///< no args
    RobotAlarm,          ///< %1 number, %2 words
    RobotRefused,        ///< %1 number, %2 words
    RobotRestarted,      ///< no args
    RobotPlaceUnsure,    ///< no args
    RobotHeld,           ///< %1 state
    RobotDisabled,       ///< no args
    RobotCannotHome,     ///< no args
    RobotStepOutside,    ///< no args
    RobotElsewhere,      ///< %1 mm, %2 mm
    RobotSlow,           ///< %1 s
    RobotDoesNotMove,    ///< %1 cm left
    AxesNone,            ///< no args
    AxisLetterUnknown,   ///< %1 letter
    AxisLetterTwice,     ///< %1 letter
    AxisCoordinateTwice, ///< %1 coordinate
    AxisMissing,         ///< %1 coordinate
    ChannelCountWrong,   ///< %1 channels, %2 objects
    ChannelTwice,        ///< %1 channel
    PortTwice,           ///< %1 port
    ProfileOther,        ///< %1 profile
    FaultOnRealRig,      ///< no args
    RigMissing,          ///< no args
    RigIncomplete,       ///< %1 device
    SimulatedPortTaken,  ///< %1 path
    // Safety monitor
    SafetyStartUp,            ///< no args
    SafetyObjectWarm,         ///< %1 object, %2 degC, %3 degC
    SafetyObjectHot,          ///< %1 object, %2 degC, %3 degC
    SafetySourceHot,          ///< %1 degC, %2 degC
    SafetySensorOpen,         ///< %1 object
    SafetySensorShort,        ///< %1 object
    SafetySensorFrozen,       ///< %1 object, %2 s
    SafetySensorJump,         ///< %1 object, %2 K/s, %3 K/s
    SafetySensorsApart,       ///< %1 object, %2 object, %3 K, %4 K
    SafetyNotWarming,         ///< %1 object, %2 K with sign, %3 s
    SafetySourceNotHeating,   ///< %1 degC, %2 degC, %3 s
    SafetySourceHeatsUnasked, ///< %1 K, %2 s, %3 K
    SafetySetPointOther,      ///< %1 degC, %2 degC
    SafetyLoopLate,           ///< %1 s, %2 s
    SafetyDiskLow,            ///< %1 MB, %2 MB
    SafetySourceSilent,       ///< %1 s
    EventFault,               ///< %1 name
    EventAlarmOver,           ///< name of a message, then its arguments
    SafetyHeatNotOff,         ///< %1 words
    SafetyHeatByHand,         ///< %1 degC
    TargetAboveWarning,       ///< %1 object, %2 degC, %3 degC
    SafetySourceNotCooling,   ///< %1 degC, %2 s
    SafetyNoWatchdog,         ///< no args
    SafetySourceStopped,      ///< no args
    SourceUnwatched,          ///< %1 profile
    EventObjectFault,         ///< %1 name, %2 object
    RecipeWithoutRun,         ///< no args
    EventHeldTooLong,         ///< %1 s; of older recordings
    HeaterGuardMissing,       ///< %1 words
    HeaterGuardTookOver,      ///< %1 words
    HeaterGuardLost,          ///< no args
    ReasonSensorDistrusted,   ///< %1 object, %2 degC, %3 degC least, %4 degC most
    SafetySensorQuiet,        ///< %1 object, %2 s
    SafetyBeyondHeat,         ///< %1 object, %2 K, %3 s
    AlarmsElsewhere,          ///< %1 file of the second Bask
    EventSensorConfirmed,     ///< %1 object, %2 degC
    SafetySourceCold,         ///< %1 degC, %2 degC, %3 K
    SafetySourceUnit,         ///< %1 degC as read, %2 degC as meant
    SafetySuspended,          ///< %1 s
    EventSuspended,           ///< %1 s
    EventMaySleep,            ///< %1 words
    EventDeviceAccepted,      ///< %1 port
    DeviceExchanged,          ///< %1 port, %2 device as remembered, %3 as it tells
    HeatLeftUnknown,          ///< %1 port
    ReasonSensorDoubted,      ///< %1 object, %2 degC
    EventRecordEnded,         ///< no args
};

struct Message;
/// Whether its arguments are the name of another message and that one's arguments, as messageWithin reads.
bool isAboutAnother(MessageCode code);
/// Such a message.
Message messageAbout(MessageCode code, const Message& about);

} // namespace bask
