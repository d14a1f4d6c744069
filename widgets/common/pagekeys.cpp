// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/pagekeys.h"

#include "widgets/common/labels.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QTextEdit>
#include <QTreeView>

#include <algorithm>
#include <utility>

namespace mb {
namespace {

/// A letter or a digit without Ctrl, Alt or Meta.
bool isSingle(const QKeySequence &keys)
{
    const int key = keys[0];
    const int modifiers = key & static_cast<int>(Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    const int bare = key & ~static_cast<int>(Qt::KeyboardModifierMask);
    return modifiers == 0 && bare >= Qt::Key_0 && bare <= Qt::Key_Z;
}

void fill(QGridLayout &grid, QWidget *box, const PageKeys &keys)
{
    for (const PageKeys::Row &row : keys.rows()) {
        if (row.keys.empty())
            continue;
        const int at = grid.rowCount();
        QLabel *const key = textLabel(PageKeys::textOf(row), TextRole::Emphasis, Tone::Text, box);
        QLabel *const does = textLabel(row.does, TextRole::Body, Tone::Text, box);
        does->setWordWrap(true);
        grid.addWidget(key, at, 0, Qt::AlignTop);
        grid.addWidget(does, at, 1);
    }
}

} // namespace

bool takesLetters(const QWidget *widget)
{
    return qobject_cast<const QLineEdit *>(widget) || qobject_cast<const QTextEdit *>(widget)
        || qobject_cast<const QPlainTextEdit *>(widget) || qobject_cast<const QAbstractSpinBox *>(widget)
        || qobject_cast<const QComboBox *>(widget) || qobject_cast<const QTreeView *>(widget);
}

PageKeys::PageKeys(QWidget &page)
    : QObject(&page)
    , m_page(page)
{
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget *, QWidget *now) { followFocus(now); });
}

PageKeys *PageKeys::of(const QWidget &page)
{
    return page.findChild<PageKeys *>(QString(), Qt::FindDirectChildrenOnly);
}

void PageKeys::add(std::vector<QKeySequence> keys, const QString &does, std::function<void()> act)
{
    Row row{keys, does, {}, std::move(keys), {}};
    for (const QKeySequence &key : row.keys) {
        auto *shortcut = new QShortcut(key, &m_page);
        shortcut->setAutoRepeat(false); // what goes to a unit is ordered each time
        connect(shortcut, &QShortcut::activated, this, act);
        row.shortcuts.push_back(shortcut);
    }
    m_rows.push_back(std::move(row));
    followFocus(QApplication::focusWidget());
}

void PageKeys::add(QAction &action, const QString &does)
{
    m_rows.push_back({{action.shortcut()}, does, {}, {action.shortcut()}, &action});
}

void PageKeys::note(std::vector<QKeySequence> keys, const QString &does)
{
    m_rows.push_back({keys, does, {}, std::move(keys), {}});
}

QString PageKeys::idOf(const Row &row) const
{
    const QString page = QString::fromLatin1(m_page.metaObject()->className());
    return page.section(QStringLiteral("::"), -1) + QLatin1Char('/')
        + (row.factory.empty() ? QString() : row.factory.front().toString(QKeySequence::PortableText));
}

void PageKeys::use(const KeyChoices &choices)
{
    for (Row &row : m_rows) {
        if (!row.isChangeable())
            continue;
        const auto chosen = choices.find(idOf(row));
        row.keys = chosen == choices.end() ? row.factory : chosen->second;
        if (row.action)
            row.action->setShortcut(row.keys.empty() ? QKeySequence() : row.keys.front());
        for (std::size_t i = 0; i < row.shortcuts.size(); ++i)
            row.shortcuts[i]->setKey(i < row.keys.size() ? row.keys[i] : QKeySequence());
    }
    followFocus(QApplication::focusWidget());
    QEvent event(keysChanged());
    for (QWidget *part : m_page.findChildren<QWidget *>())
        QCoreApplication::sendEvent(part, &event);
}

void PageKeys::followFocus(const QWidget *now)
{
    const bool letters = !takesLetters(now);
    for (const Row &row : m_rows) {
        for (QShortcut *shortcut : row.shortcuts)
            shortcut->setEnabled(letters || !isSingle(shortcut->key()));
    }
}

QString PageKeys::textOf(const Row &row)
{
    QStringList texts;
    for (const QKeySequence &key : row.keys)
        texts << key.toString(QKeySequence::NativeText);
    texts.removeDuplicates(); // two keys that have one name
    return texts.join(QStringLiteral(", "));
}

QEvent::Type keysChanged()
{
    static const auto type = static_cast<QEvent::Type>(QEvent::registerEventType());
    return type;
}

namespace {

/// In the words of the window's language; what names no key is left as it is.
QString inItsLanguage(const QString &key)
{
    const QKeySequence keys(key, QKeySequence::PortableText);
    for (int i = 0; i < keys.count(); ++i) {
        if (keys[static_cast<uint>(i)] == Qt::Key_unknown)
            return key;
    }
    return keys.isEmpty() ? key : keys.toString(QKeySequence::NativeText);
}

class NamedKeys : public QObject {
public:
    NamedKeys(QLabel &label, QString words, QStringList factory)
        : QObject(&label)
        , m_label(label)
        , m_words(std::move(words))
        , m_factory(std::move(factory))
    {
        label.installEventFilter(this);
        follow();
    }

protected:
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() == keysChanged())
            follow();
        return false;
    }

private:
    void follow() { m_label.setText(wordsOfKeys(m_label, m_words, m_factory)); }

    QLabel &m_label;
    QString m_words;
    QStringList m_factory;
};

} // namespace

QString keyShown(const QWidget &button, const QString &factory)
{
    const QKeySequence came(factory, QKeySequence::PortableText);
    for (const QWidget *around = &button; around && !factory.isEmpty(); around = around->parentWidget()) {
        const PageKeys *const keys = PageKeys::of(*around);
        for (const PageKeys::Row &row : keys ? keys->rows() : std::vector<PageKeys::Row>()) {
            const bool its = std::ranges::find(row.factory, came) != row.factory.end();
            if (its && row.isChangeable())
                return row.keys == row.factory ? inItsLanguage(factory) : PageKeys::textOf(row);
        }
    }
    return inItsLanguage(factory);
}

QString wordsOfKeys(const QWidget &near, const QString &words, const QStringList &factory)
{
    const QString between = QStringLiteral(" · ");
    QStringList said;
    for (QString part : words.split(between)) {
        bool isThere = true;
        for (int i = 0; i < factory.size(); ++i) {
            const QString place = QLatin1Char('%') + QString::number(i + 1);
            const QString key = keyShown(near, factory[i]);
            isThere = isThere && !(key.isEmpty() && part.contains(place));
            part.replace(place, key);
        }
        if (isThere)
            said << part;
    }
    return said.join(between);
}

void nameKeys(QLabel &label, const QString &words, const QStringList &factory)
{
    new NamedKeys(label, words, factory);
}

void showKeys(
    QWidget &parent, const QString &page, const std::vector<const PageKeys *> &keys, const std::function<void()> &help)
{
    auto *dialog = new QDialog(&parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("keys"));
    dialog->setWindowTitle(PageKeys::tr("Keys: %1").arg(page));
    auto *column = new QVBoxLayout(dialog);
    auto *scroll = new QScrollArea(dialog);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setAccessibleName(dialog->windowTitle());
    auto *box = new QWidget(scroll);
    auto *grid = new QGridLayout(box);
    grid->setColumnStretch(1, 1);
    grid->setHorizontalSpacing(QFontMetrics(dialog->font()).horizontalAdvance(QStringLiteral("MM")));
    for (const PageKeys *table : keys) {
        if (!table || table->rows().empty())
            continue;
        const bool ofPage = table == keys.front();
        grid->addWidget(new SectionLabel(ofPage ? page : PageKeys::tr("Everywhere"), box), grid->rowCount(), 0, 1, 2);
        fill(*grid, box, *table);
    }
    scroll->setWidget(box);
    column->addWidget(scroll, 1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    column->addWidget(buttons);
    if (help) {
        buttons->addButton(QDialogButtonBox::Help);
        QObject::connect(buttons, &QDialogButtonBox::helpRequested, dialog, help);
        QObject::connect(new QShortcut(Qt::Key_F1, dialog), &QShortcut::activated, dialog, help);
    }
    const QSize room = parent.window()->size();
    dialog->resize(std::min(dialog->sizeHint().width() + scroll->verticalScrollBar()->sizeHint().width()
                           + QFontMetrics(dialog->font()).horizontalAdvance(QString(50, QLatin1Char('n'))),
                       room.width() * 9 / 10),
        std::min(box->sizeHint().height() + column->sizeHint().height(), room.height() * 9 / 10));
    dialog->show();
}

} // namespace mb
