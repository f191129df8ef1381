#pragma once
// Files and addresses opened by the desktop's programs.

class QUrl;

namespace bask {

/// Starts the desktop's program for a file or an address and waits neither for it nor for the desktop.
/// Returns false if nothing could be started; what a program that was started does is not known.
bool openOnDesktop(const QUrl& address);

} // namespace bask
