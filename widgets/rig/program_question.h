#pragma once
// Asks a person whether a program may be started on this computer.

#include "engine/runtime/command.h"

#include <functional>
#include <string>

class QWidget;

namespace bask {

/// Shows the whole command and the files that it starts; not modal. `confirm` is called with what was seen.
void askForProgram(QWidget* parent, const std::string& command,
                   const std::function<void(const ConfirmProgram&)>& confirm);

} // namespace bask
