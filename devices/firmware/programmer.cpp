// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/programmer.h"

#include "async/sleep.h"
#include "firmware/intelhex.h"

#include <QDir>
#include <QTemporaryFile>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Duration programPatience = 60s; ///< between two words; a whole flash is erased and written in less

} // namespace

Result<std::unique_ptr<QTemporaryFile>> hexFileFor(const FirmwareImage &image, std::string_view program)
{
    auto file = std::make_unique<QTemporaryFile>(QDir::tempPath() + QStringLiteral("/motorbench-XXXXXX.hex"));
    const std::string text = toIntelHex(image);
    const auto size = static_cast<qint64>(text.size());
    if (!file->open() || file->write(text.data(), size) != size || !file->flush())
        return fail(Fault::LinkLost,
            say("a temporary file for %1 cannot be written: %2", program, file->errorString().toStdString()),
            say("make room in %1", QDir::tempPath().toStdString()));
    return file;
}

Task<ExternalProgram::Exit> runProgrammer(Clock &clock, ExternalProgram::Command command, Message remedy,
    std::function<void(const ExternalProgram::Piece &)> take, Progress &progress)
{
    ExternalProgram program(clock);
    co_await program.start(command);
    for (;;) {
        const auto piece = co_await program.next(programPatience);
        if (!piece && piece.error().fault == Fault::Timeout)
            co_return fail(Fault::Timeout, say("%1 said nothing for a minute and was ended", command.program), remedy);
        if (!piece)
            co_return fail(piece.error());
        if (!*piece)
            break;
        take(**piece);
        if ((*piece)->complete && !(*piece)->text.empty())
            progress.log(Severity::Info, Message::verbatim((*piece)->text));
    }
    co_return program.exit();
}

} // namespace mb
