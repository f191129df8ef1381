#pragma once
// The engine's messages and errors as sentences for the operator, in the window's language.

#include "engine/base/result.h"

#include <QString>

namespace bask {

/// Sentence of a message. Arguments that are words of the engine (the command and state of a refusal) are
/// translated too.
QString sentence(const Message& message);

/// "file: sentence", or the sentence alone when the error names no place.
QString sentence(const Error& error);

} // namespace bask
