#pragma once
// What an edit of the experiment is about, found by comparing the experiments before and after it.

#include "app/page.h"
#include "engine/model/experiment.h"

#include <QString>

namespace bask {

/// What the engine has to be told of it: the narrowest command. Which states allow it follows.
enum class EditScope { Targets, Controller, Vision, All };

enum class EditKind {
    Targets,
    Controller,
    Markers,
    CameraLens,
    CameraPlace,
    Vision,
    SourcePlace,
    Following,
    Start,
    SetPoint,
    Emittance,
    Workspace,
    MotionLimits,
    Safety,
    Rig,
    Mounting,
    Name,
    StartValues,
    Material,
    Outline,
    Object,
    ObjectAdded,
    ObjectRemoved,
    Other
};

struct ExperimentEdit {
    EditKind kind = EditKind::Other;
    int object = -1; ///< the one it is about; -1: none or several
    EditScope scope = EditScope::All;
    Page page = Page::Objects; ///< where it is seen
    bool operator==(const ExperimentEdit&) const = default;
};

/// Of two that differ. The way back has the same kind, scope and page, but for additions and removals.
ExperimentEdit compared(const Experiment& before, const Experiment& after);

/// In the window's language, as in "Undo: move of “bunny”".
QString editWords(const ExperimentEdit& edit, const Experiment& before, const Experiment& after);

/// A slider that is dragged and a key that is held make many such edits in a row.
bool mayBeOneOfMany(EditKind kind);

} // namespace bask
