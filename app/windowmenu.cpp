// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/windowmenu.h"

#include "app/about.h"
#include "app/keydesk.h"
#include "app/preferences.h"
#include "transport/backends/gpiolines.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/guarded.h"
#include "widgets/connection/addlinkdialog.h"
#include "widgets/connection/deviceactions.h"
#include "widgets/plots/sampleswindow.h"

#include <QMenu>

namespace mb {

WindowMenu::WindowMenu(Workbench &workbench, ThemeSource &theme, Settings &settings, QWidget &window)
    : QObject(&window)
    , m_workbench(workbench)
    , m_theme(theme)
    , m_settings(settings)
    , m_window(window)
    , m_menu(new QMenu(&window))
{
    m_menu->addAction(tr("Add link…"), this, &WindowMenu::addLink);
    m_menu->addAction(tr("Open recording…"), this, &WindowMenu::openRecording, QKeySequence::Open);
    m_menu->addAction(tr("Open the simulated bench"), this, &WindowMenu::openSimulation);
    m_menu->addSeparator();
    m_menu->addAction(tr("Open the folder of a machine…"), this, [this] { Q_EMIT projectWanted(true); });
    m_menu->addAction(tr("Save the machine into a folder…"), this, [this] { Q_EMIT projectWanted(false); });
    m_menu->addSeparator();
    m_menu->addAction(tr("Commands…"), this, &WindowMenu::commandsRequested, QKeySequence(QStringLiteral("Ctrl+K")));
    m_menu->addAction(
        tr("Switch between dark and light"), this, &WindowMenu::switchTheme, QKeySequence(QStringLiteral("Ctrl+T")));
    m_menu->addAction(tr("Preferences…"), this, &WindowMenu::askPreferences, QKeySequence(QStringLiteral("Ctrl+,")));
    m_menu->addSeparator();
    m_menu->addAction(tr("Help"), this, [this] { Q_EMIT helpWanted(QStringLiteral("first-hour")); });
    m_menu->addAction(tr("Keys"), this, &WindowMenu::keysRequested);
    m_menu->addAction(tr("About MotorBench"), this, [this] {
        auto *about = new About(&m_window);
        about->setAttribute(Qt::WA_DeleteOnClose);
        about->show();
    });
    m_menu->addAction(tr("Quit"), &m_window, &QWidget::close, QKeySequence::Quit);
}

void WindowMenu::addTo(PageKeys &keys) const
{
    const std::pair<QKeySequence, QString> said[]
        = {{QKeySequence(QStringLiteral("Ctrl+K")), tr("lists everything that can be done, by name")},
            {QKeySequence(QStringLiteral("Ctrl+,")), tr("shows the preferences")},
            {QKeySequence(QStringLiteral("Ctrl+T")), tr("switches between dark and light")},
            {QKeySequence::Open, tr("opens a recording")}, {QKeySequence::Quit, tr("quits")}};
    for (QAction *entry : m_menu->actions()) {
        for (const auto &[key, does] : said) {
            if (entry->shortcut() == key)
                keys.add(*entry, does);
        }
    }
}

void WindowMenu::addLink()
{
    const auto choices = [this] {
        std::vector<std::string> open;
        for (const LinkView &link : m_workbench.snapshot().links)
            open.push_back(link.address);
        return linkChoices(m_workbench.listings(), open);
    };
    auto *dialog = new AddLinkDialog(choices(), m_theme, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(&m_workbench, &Workbench::changed, dialog, [dialog, choices] { dialog->setChoices(choices()); });
    std::vector<std::pair<QString, QString>> lines;
    for (const GpioLineListing &line : gpioLines()) {
        if (!line.used)
            lines.emplace_back(QString::fromStdString(line.name), QString::fromStdString(line.label));
    }
    dialog->setLines(lines);
    connect(dialog, &AddLinkDialog::chosen, this, &WindowMenu::openAddress);
    connect(dialog, &AddLinkDialog::recordingWanted, this, &WindowMenu::openRecording);
    connect(dialog, &AddLinkDialog::helpWanted, this, [this] { Q_EMIT helpWanted(QStringLiteral("connecting")); });
    dialog->open();
}

void WindowMenu::openAddress(const QString &address, bool keep)
{
    mb::openAddress(m_workbench, address, [keep, &settings = m_settings](const QString &opened) {
        if (keep)
            settings.addLink(opened);
    });
}

void WindowMenu::openRecording()
{
    const QStringList filters{tr("All recordings (*.log *.asc *.txt *.mcap *.csv)"),
        tr("Frames: candump and Vector ASC logs (*.log *.asc *.txt)"), tr("Samples: MCAP, CSV (*.mcap *.csv)"),
        tr("All files (*)")};
    askForFile(m_window, tr("Open a recording"), filters.join(QStringLiteral(";;")), {},
        [this](const QString &path) { openFile(path); });
}

void WindowMenu::openFile(const QString &path)
{
    if (SamplesWindow::isFor(path)) {
        (new SamplesWindow(path, m_theme, &m_window))->show();
        return;
    }
    mb::openRecording(
        m_workbench, path, guarded(this, [this](const QString &address) { Q_EMIT framesOpened(address); }));
}

void WindowMenu::openSimulation()
{
    LinkAddress address;
    address.scheme = "sim";
    m_workbench.send(orders::OpenLink{address});
}

void WindowMenu::switchTheme()
{
    Theme next
        = m_theme.theme().dark ? lightTheme(m_theme.theme().bodyPointSize) : darkTheme(m_theme.theme().bodyPointSize);
    next.reducedMotion = m_theme.theme().reducedMotion;
    m_theme.setTheme(next);
    m_settings.setTheme(next.name);
}

void WindowMenu::askPreferences()
{
    Look look = m_settings.look();
    look.theme = m_theme.theme().name;
    auto *dialog = new Preferences(look, m_keys->book(), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, look] {
        m_keys->use(dialog->keys());
        if (dialog->look() == look)
            return;
        m_settings.setLook(dialog->look());
        Q_EMIT lookChosen();
    });
    dialog->open();
}

} // namespace mb
