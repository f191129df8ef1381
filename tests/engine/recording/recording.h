#pragma once
// Made-up runs to record, and a second process that records until it is killed.

#include "engine/recording/session_file.h"
#include "engine/thermography/camera_profile.h"

#include <string>

namespace bask::test {

/// The experiment of two disks that the tests record.
Experiment twoDisks();

/// Sample number k of a run at 1 Hz: every column differs and none is round; some are NaN.
TraceSample madeUpSample(const Experiment& experiment, int k);

/// Picture number k of a camera with this profile: temperatures that it can tell, and one saturated pixel.
ThermalPicture madeUpPicture(const ThermalProfile& profile, int k);

/// A sample without the values that came after version 1 of the files.
TraceSample asVersionOne(TraceSample sample);

/// True when the two samples are the same but for the coordinates' last digits (they are stored as a
/// quaternion).
bool sameSample(const TraceSample& a, const TraceSample& b);

/// Records without end: a sample every 10 ms, and the seconds since the start of each on standard output once
/// it is in. The body of the process that the tests kill.
int recordUntilKilled(const std::string& path);

/// Records without end as fast as it can, some samples at once and now and then a note, and prints how many
/// samples are safe after each commit.
int recordAndAcknowledge(const std::string& path, unsigned seed);

/// Replaces the session there without end, each with one sample, and prints a line after each.
int replaceUntilKilled(const std::string& path);

} // namespace bask::test
