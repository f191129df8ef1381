#pragma once
// Asks a person before an action on a real rig that needs confirmation.

#include <QString>

#include <functional>

class QWidget;

namespace bask {

/// Not modal, so that STOP stays reachable; the default changes nothing. An earlier question with the same
/// object name is removed first.
void askOnTheWayUp(QWidget* parent, const QString& name, const QString& title, const QString& text,
                   const QString& yes, const std::function<void()>& then);
/// Removes the question, if there is one.
void dropQuestion(QWidget* parent, const QString& name);

} // namespace bask
