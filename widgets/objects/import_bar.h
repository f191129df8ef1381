#pragma once
// Asks what a contour file does not tell: the unit of a CSV, or the scale of a picture.

#include "engine/shape/contour_import.h"

#include <QFrame>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace bask {

/// Hidden until a file is offered. Object names: "importFile", "importUnit", "importScale", "importAccept",
/// "importCancel".
class ImportBar : public QFrame {
    Q_OBJECT

public:
    explicit ImportBar(QWidget* parent = nullptr);

    /// Asks for the file's unit or scale.
    void offer(const QString& path);
    static bool isImage(const QString& path);

signals:
    void accepted(const QString& path, const bask::ContourImportOptions& options);
    void cancelled();

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void retranslate();
    void accept();

    QString m_path;
    QLabel* m_file;
    QLabel* m_question;
    QComboBox* m_unit;
    QDoubleSpinBox* m_scale;
    QPushButton* m_accept;
    QPushButton* m_cancel;
};

} // namespace bask
