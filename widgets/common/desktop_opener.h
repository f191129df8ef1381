#pragma once
// Files and addresses opened by the desktop's programs.

class QString;
class QUrl;

namespace bask {

/// Starts the desktop's program for a file or an address and waits neither for it nor for the desktop, but
/// for the disks that PATH names: not for the GUI thread. Returns false if nothing could be started; what a
/// program that was started does is not known.
bool openOnDesktop(const QUrl& address);
/// The same by another program than xdg-open: its name in PATH, or its file.
bool openBy(const QString& program, const QUrl& address);

} // namespace bask
