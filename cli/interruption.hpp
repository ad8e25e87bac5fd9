// SPDX-License-Identifier: GPL-3.0-or-later
// How the program ends by a signal, or where there is no memory left for an exception.
#pragma once

namespace ehd::cli {

/// From now on SIGINT, SIGTERM and SIGHUP remove the temporary files, print `message` and a line feed on standard
/// error, and end the program as they usually do; so does SIGPIPE, without a line. A signal that the caller of the
/// program ignores (nohup) stays ignored. The text must live as long as the program. A later call changes the message.
void say_when_interrupted(const char* message);

/// For main: every command says that it was interrupted. A file that grows beyond the limit of the shell (ulimit -f) is
/// an error of the write, not a signal. Lack of memory is one line and exit code 1 even where there is none left for
/// the exception itself.
void handle_signals();

}  // namespace ehd::cli
