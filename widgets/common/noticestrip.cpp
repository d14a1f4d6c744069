// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/noticestrip.h"

#include "widgets/common/layoutin.h"

#include <QPainter>

namespace mb {
namespace {

constexpr int narrow = 900; ///< in units of the theme: below it a notice has two lines

} // namespace

NoticeStrip::NoticeStrip(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_stripe(new DemoStripe(theme, this))
    , m_banners(new BannerStack(theme, this))
{
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    auto *row = layoutIn<QHBoxLayout>(this, 0);
    row->addWidget(m_stripe);
    row->addWidget(m_banners, 1);
    connect(m_banners, &BannerStack::countChanged, this, &NoticeStrip::fit);
    connect(&theme, &ThemeSource::changed, this, &NoticeStrip::fit);
    fit();
}

void NoticeStrip::fit()
{
    const bool notices = m_banners->count() > 0;
    m_banners->setTwoLines(width() < m_theme.theme().u(narrow));
    m_stripe->setCompact(notices); // first: what is shown is laid out at once
    m_banners->setVisible(notices);
    setFixedHeight(m_banners->height());
}

QSize NoticeStrip::minimumSizeHint() const
{
    return {1, m_banners->height()};
}

void NoticeStrip::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.fillRect(rect(), theme.head);
    painter.fillRect(0, height() - 1, width(), 1, theme.line);
}

} // namespace mb
