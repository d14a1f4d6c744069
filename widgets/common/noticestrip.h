// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/banner.h"
#include "widgets/common/demostripe.h"

namespace mb {

/// The row under the header: what is simulated or replayed, and the notice that matters most. Its height depends on the
/// window's width and the size of the text only, never on what it shows.
class NoticeStrip : public QWidget {
    Q_OBJECT
public:
    explicit NoticeStrip(const ThemeSource &theme, QWidget *parent = nullptr);
    BannerStack &banners() { return *m_banners; }
    DemoStripe &stripe() { return *m_stripe; }
    /// Long words do not hold the window wide.
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *) override { fit(); }
    void paintEvent(QPaintEvent *event) override;

private:
    void fit();

    const ThemeSource &m_theme;
    DemoStripe *m_stripe = nullptr;
    BannerStack *m_banners = nullptr;
};

} // namespace mb
