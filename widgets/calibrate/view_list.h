#pragma once
// The views of a calibration: for each a small picture, its residual, and whether it is used.

#include <QTreeWidget>

class QImage;

namespace bask {

/// A ticked view is used. Object name: "viewList".
class ViewList : public QTreeWidget {
    Q_OBJECT

public:
    explicit ViewList(QWidget* parent = nullptr);

    /// Adds a view with the next number, ticked.
    void add(const QImage& picture);
    int count() const { return topLevelItemCount(); }
    /// `residual_px` is empty if not known; `standsOut` marks the view, also in words.
    void setResidual(int view, std::optional<double> residual_px, bool standsOut);
    bool isUsed(int view) const;
    void setUsed(int view, bool isUsed);

    static constexpr int kPictureWidth = 48, kPictureHeight = 27;

signals:
    void usedChanged(int view, bool isUsed);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void showResidual(QTreeWidgetItem* item);
};

} // namespace bask
