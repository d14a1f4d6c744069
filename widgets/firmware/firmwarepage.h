// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QWidget>

#include <span>

class QStackedWidget;

namespace mb {

class QueueBoard;
class Segmented;
class UnitUpdate;

/// Firmware: of the selected device, or of many units one after the other. An image can be dropped on it. GUI thread.
class FirmwarePage : public QWidget {
    Q_OBJECT
public:
    FirmwarePage(Workbench &workbench, Selection &selection, std::span<const Family *const> families,
        const ThemeSource &theme, QWidget *parent = nullptr);

    [[nodiscard]] QueueBoard &queue() const { return *m_queue; }
    [[nodiscard]] UnitUpdate &unit() const { return *m_unit; }
    void showQueue(bool on);
    [[nodiscard]] bool isQueueShown() const;

    /// As the ones of what is shown.
    void loadImage(const QString &path);
    void startUpdate();
    [[nodiscard]] bool canStart() const;

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    [[nodiscard]] QWidget *buildHead(
        Workbench &workbench, Selection &selection, std::span<const Family *const> families, const ThemeSource &theme);

    Segmented *m_which = nullptr;
    QStackedWidget *m_faces = nullptr;
    UnitUpdate *m_unit = nullptr;
    QueueBoard *m_queue = nullptr;
};

} // namespace mb
