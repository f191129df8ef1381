#pragma once
// Asks how large a picture shall be, and where it shall go.

#include <QDialog>

#include <optional>

class QComboBox;
class QSpinBox;

namespace bask {

/// Width and height in pixels, typed or from a list. Object names: "pictureSize" (list), "pictureWidth",
/// "pictureHeight".
class PictureDialog : public QDialog {
    Q_OBJECT

public:
    static constexpr int kMin_px = 100, kMax_px = 8192;

    /// Starts with `size`, which leads the list as the view's; `max` bounds either side.
    PictureDialog(const QString& title, QSize size, int max, QWidget* parent);

    QSize size_px() const;

    struct Order {
        QString path; ///< a file; of an animation a folder
        QSize size_px;
    };
    /// The dialog and then the place; nothing when the person gives up.
    static std::optional<Order> askPicture(QSize size, QWidget* parent);
    static std::optional<Order> askAnimation(QSize size, QWidget* parent);

private:
    void choose();
    void findSize();

    QComboBox* m_sizes; ///< last: another one
    QSpinBox* m_width;
    QSpinBox* m_height;
};

} // namespace bask
