// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/helpdesk.h"

#include "widgets/common/iconbutton.h"
#include "widgets/help/helptopics.h"
#include "widgets/help/helpwindow.h"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QKeyEvent>

namespace mb {
namespace {

struct FormTopic {
    const char *form; ///< class
    const char *topic;
};
constexpr FormTopic formTopics[] = {
    {"mb::AddLinkDialog", "connecting"},
    {"mb::Preferences", "files"},
    {"mb::BatteryDialog", "tuning"},
    {"mb::ExperimentDialog", "tuning"},
    {"mb::About", "first-hour"},
};
constexpr const char *start = "first-hour";

} // namespace

HelpDesk::HelpDesk(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget &window)
    : QObject(&window)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
    , m_window(window)
{
    qApp->installEventFilter(this);
}

QString HelpDesk::hardware() const
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    return device ? hardwareTopic(device->family->key) : QString();
}

QString HelpDesk::topicOf(PageId page) const
{
    const QString device = hardware();
    switch (page) {
    case PageId::Overview: return device.isEmpty() ? QString::fromLatin1(start) : device;
    case PageId::Parameters:
    case PageId::Firmware: return device.isEmpty() ? QStringLiteral("service") : device;
    case PageId::Tune:
    case PageId::Design: return QStringLiteral("tuning");
    case PageId::Plots: return QStringLiteral("plots");
    case PageId::Bus: return QStringLiteral("connecting");
    case PageId::Log: return QStringLiteral("troubleshooting");
    case PageId::Reports: return QStringLiteral("service");
    }
    return QString::fromLatin1(start);
}

QString HelpDesk::topicOfForm(const QWidget &form)
{
    for (const FormTopic &row : formTopics) {
        if (qstrcmp(form.metaObject()->className(), row.form) == 0)
            return QLatin1String(row.topic);
    }
    return {};
}

HelpWindow &HelpDesk::open(const QString &topic)
{
    return HelpWindow::open(m_theme, m_window, topic);
}

QString HelpDesk::shown() const
{
    const auto *help = m_window.findChild<HelpWindow *>(QString(), Qt::FindDirectChildrenOnly);
    return help && help->isVisible() ? help->topic() : QString();
}

QWidget *HelpDesk::makeButton(std::function<PageId()> shown, QWidget *parent)
{
    auto *button = new IconButton(m_theme, Symbol::Help, tr("Help for this page"), parent);
    button->setObjectName(QStringLiteral("pageHelp"));
    button->setKeyHint(QStringLiteral("F1, F1"));
    connect(button, &QToolButton::clicked, this, [this, shown = std::move(shown)] { (void)open(topicOf(shown())); });
    return button;
}

/// A `?` for a form that has none of its own.
void HelpDesk::equip(QDialog &form)
{
    auto *buttons = form.findChild<QDialogButtonBox *>();
    if (!buttons || buttons->button(QDialogButtonBox::Help))
        return;
    buttons->addButton(QDialogButtonBox::Help);
    connect(buttons, &QDialogButtonBox::helpRequested, this, [this, &form] { (void)open(topicOfForm(form)); });
}

bool HelpDesk::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::Show && event->type() != QEvent::KeyPress)
        return false;
    auto *form = qobject_cast<QDialog *>(watched);
    if (!form || topicOfForm(*form).isEmpty() || !form->parentWidget() || form->parentWidget()->window() != &m_window)
        return false;
    if (event->type() == QEvent::Show) {
        equip(*form);
    } else if (static_cast<QKeyEvent *>(event)->key() == Qt::Key_F1) {
        (void)open(topicOfForm(*form));
        return true;
    }
    return false;
}

} // namespace mb
