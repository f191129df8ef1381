#pragma once
// What an edit of the experiment changes, found by comparing the experiments before and after it.

#include "app/page.h"
#include "engine/model/experiment.h"

#include <QString>

namespace bask {

/// The narrowest command that tells the engine about the edit. It determines which states allow the edit.
enum class EditScope { Targets, Controller, Vision, All };

enum class EditKind {
    Targets,
    Controller,
    Markers,
    CameraLens,
    CameraPlace,
    Vision,
    ThermalCamera,
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
    Air,
    ObjectAdded,
    ObjectRemoved,
    Other
};

struct ExperimentEdit {
    EditKind kind = EditKind::Other;
    int object = -1; ///< the object concerned; -1 for none or several
    EditScope scope = EditScope::All;
    Page page = Page::Objects; ///< the page that shows it
    bool operator==(const ExperimentEdit&) const = default;
};

/// Compares two different experiments. The reverse edit has the same kind, scope and page, except for
/// additions and removals.
ExperimentEdit compared(const Experiment& before, const Experiment& after);

/// Returns the edit in words in the window's language, as in "Undo: move of “bunny”".
QString editWords(const ExperimentEdit& edit, const Experiment& before, const Experiment& after);

/// Returns whether a dragged slider or a key kept pressed makes many such edits in a row.
bool mayBeOneOfMany(EditKind kind);

} // namespace bask
