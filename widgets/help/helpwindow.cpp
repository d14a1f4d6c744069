// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/helpwindow.h"

#include "widgets/help/helpbrowser.h"
#include "widgets/help/helppages.h"
#include "widgets/help/helptopics.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QListWidget>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace mb {

HelpWindow::HelpWindow(const ThemeSource &theme, QWidget *parent)
    : QDialog(parent)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("help"));
    m_list = new QListWidget(this);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_browser = new HelpBrowser(theme, this);
    name();
    fillList();
    auto *row = new QHBoxLayout;
    row->addWidget(m_list);
    row->addWidget(m_browser, 1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto *column = new QVBoxLayout(this);
    column->addLayout(row, 1);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connectList();
    const QSize room = parent ? parent->window()->size() : QSize(1280, 800);
    resize(
        std::min(theme.theme().u(980), room.width() * 9 / 10), std::min(theme.theme().u(700), room.height() * 9 / 10));
}

/// A link may have led to a page of another language, or to one that is not in the list: what is marked says what is shown, and a
/// click on it leads back to the page itself.
void HelpWindow::connectList()
{
    const auto open = [this](const QListWidgetItem *item) {
        const QString topic = item ? item->data(Qt::UserRole).toString() : QString();
        if (item && m_browser->file() != helpFile(topic))
            m_browser->showPage(topic);
    };
    connect(m_list, &QListWidget::currentItemChanged, this, open);
    connect(m_list, &QListWidget::itemClicked, this, open);
    connect(m_browser, &HelpBrowser::pageShown, this, [this](const QString &topic) {
        const QSignalBlocker quiet(m_list);
        mark(topic);
    });
}

void HelpWindow::name()
{
    setWindowTitle(tr("Help"));
    setAccessibleName(tr("Help"));
    m_list->setAccessibleName(tr("Pages of the help"));
}

void HelpWindow::changeEvent(QEvent *event)
{
    QDialog::changeEvent(event);
    if (event->type() != QEvent::LanguageChange)
        return;
    name();
    const QSignalBlocker quiet(m_list); // the page changes by itself
    m_list->clear();
    fillList();
    mark(m_browser->topic());
}

void HelpWindow::fillList()
{
    const Theme &theme = m_theme.theme();
    int widest = 0;
    for (const HelpTopic &topic : helpTopics()) {
        auto *item = new QListWidgetItem(topic.title, m_list);
        item->setData(Qt::UserRole, topic.key);
        item->setSizeHint({0, theme.u(28)});
        widest = std::max(widest, m_list->fontMetrics().horizontalAdvance(topic.title));
    }
    const int pad = m_list->fontMetrics().height() * 2;
    m_list->setFixedWidth(widest + pad);
}

void HelpWindow::mark(const QString &topic)
{
    m_list->setCurrentRow(-1);
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->data(Qt::UserRole).toString() == topic)
            m_list->setCurrentRow(row);
    }
}

void HelpWindow::showTopic(const QString &topic)
{
    mark(topic);
}

QString HelpWindow::topic() const
{
    return m_browser->topic();
}

HelpWindow &HelpWindow::open(const ThemeSource &theme, QWidget &parent, const QString &topic)
{
    auto *window = parent.findChild<HelpWindow *>(QString(), Qt::FindDirectChildrenOnly);
    if (!window) {
        window = new HelpWindow(theme, &parent);
        window->setAttribute(Qt::WA_DeleteOnClose);
    }
    window->showTopic(topic);
    window->show();
    window->raise();
    return *window;
}

} // namespace mb
