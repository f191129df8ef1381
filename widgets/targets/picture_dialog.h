#pragma once
// Asks for the size of a picture and where to save it.

#include <QDialog>

#include <optional>

class QComboBox;

namespace bask {

class WholeNumberField;

/// Width and height in pixels, typed or from a list. Object names: "pictureSize" (list), "pictureWidth",
/// "pictureHeight".
class PictureDialog : public QDialog {
    Q_OBJECT

public:
    static constexpr int kMin_px = 100, kMax_px = 8192;

    /// Starts with `size`, which is first in the list as the view's; `max` limits both sides.
    PictureDialog(const QString& title, QSize size, int max, QWidget* parent);

    QSize size_px() const;

    struct Order {
        QString path; ///< a file; for an animation a folder
        QSize size_px;
    };
    /// Asks for size and place; empty if the person cancels.
    static std::optional<Order> askPicture(QSize size, QWidget* parent);
    static std::optional<Order> askAnimation(QSize size, QWidget* parent);

private:
    void choose();
    void findSize();

    QComboBox* m_sizes; ///< the last entry is another size
    WholeNumberField* m_width;
    WholeNumberField* m_height;
};

} // namespace bask
