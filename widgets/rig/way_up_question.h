#pragma once
// Asks a person before something of a real rig goes up.

#include <QString>

#include <functional>

class QWidget;

namespace bask {

/// Not modal, so that STOP stays within reach; the default is to leave all as it is. A question of the same
/// object name is taken back first.
void askOnTheWayUp(QWidget* parent, const QString& name, const QString& title, const QString& text,
                   const QString& yes, const std::function<void()>& then);
/// Takes it back; nothing where there is none.
void dropQuestion(QWidget* parent, const QString& name);

} // namespace bask
