// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/leastheight.h"
#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"
#include "widgets/firmware/imagechoice.h"

class QLabel;
class QProgressBar;
class QVBoxLayout;

namespace mb {

class CheckRow;
class CommandButton;
class RoutePanel;
class ThemeSource;
class UpdateLog;
class UpdateSide;

/// Firmware of the selected device: image, checks before the start, page map, rate, time left, cancel, log. Says done only
/// when the device has answered with the new version. GUI thread.
class UnitUpdate : public LeastHeight {
    Q_OBJECT
public:
    UnitUpdate(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent);

    /// Reads and checks an image; what is wrong with it stands in the page.
    void loadImage(const QString &path);
    /// As the button: does nothing unless everything before the start holds.
    void start();
    [[nodiscard]] bool canStart() const;

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void buildImage(QVBoxLayout &column);
    void buildProgress(QVBoxLayout &column);
    void buildBody(QVBoxLayout &column);
    void askImage();
    void inspectImage();
    void follow();
    void followDevice(const DeviceView *device);
    void followChecks(const DeviceView *device);
    void followOrders(const DeviceView *device, const OperationView *operation);
    void followProgress(const OperationView *operation);
    void followLog(const OperationView *operation);
    void followSafety(const OperationView *operation);
    void followRoute(const DeviceView *device, const OperationView *operation);
    void showEnd(const OperationView &operation);
    [[nodiscard]] std::optional<OperationView> shownOperation(const DeviceView *device) const;
    [[nodiscard]] QString hindrance() const;
    [[nodiscard]] QString remaining(const OperationStatus &status) const;
    [[nodiscard]] UpdateWords wordsFor(const OperationView *operation) const;

    Workbench &m_workbench;
    Selection &m_selection;
    const ThemeSource &m_theme;
    ImageChoice m_image;
    DeviceId m_inspectedFor;
    QLabel *m_imageName = nullptr;
    QLabel *m_imageDetail = nullptr;
    QLabel *m_deviceName = nullptr;
    QLabel *m_versions = nullptr;
    CheckRow *m_checks = nullptr;
    RoutePanel *m_route = nullptr;
    CommandButton *m_start = nullptr;
    CommandButton *m_cancel = nullptr;
    QLabel *m_step = nullptr;
    QLabel *m_rate = nullptr;
    QProgressBar *m_progress = nullptr;
    UpdateLog *m_log = nullptr;
    UpdateSide *m_side = nullptr;
    OperationId m_shownOperation;
    OperationId m_lastOfOthers; ///< operations so far were not of the image that is open
};

} // namespace mb
