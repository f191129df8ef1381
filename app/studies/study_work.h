#pragma once
// The studies that can be divided: what is computed for a request, and its files.

#include "app/studies/study_output.h"
#include "app/studies/study_request.h"
#include "engine/studies/alarm_study.h"
#include "engine/studies/closed_loop_study.h"

namespace bask {

/// The study of a request, on the program's own rigs. Errors: those of its files.
Result<ClosedLoopStudy> studyOf(const ClosedLoopRequest& request);
Result<AlarmStudy> studyOf(const AlarmRequest& request);

StudyNames namesOf(const ClosedLoopRequest& request);
StudyNames namesOf(const AlarmRequest& request);

} // namespace bask
