#pragma once
// The engine's messages and errors as sentences for the operator, in the window's language.

#include "engine/base/result.h"

#include <QString>

namespace bask {

/// Returns the sentence of a message. Arguments that are words of the engine (the command and state of a
/// refusal) are also translated.
QString sentence(const Message& message);

/// Returns "file: sentence", or only the sentence if the error has no place.
QString sentence(const Error& error);

} // namespace bask
