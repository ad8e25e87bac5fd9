function result = ehd_run(subcommand, words)
% EHD_RUN  Runs the program ehd and reads its JSON (for Octave 7 and MATLAB).
%
%   result = ehd_run('solve', {'--M', 20, '--L', 10})
%
% words  cell of texts and numbers: what stands behind the subcommand on the command line. Numbers keep all digits.
%
% The environment variable EHD_PROGRAM may name the program; else it is found in PATH. Bad input is the error
% 'ehd:input' with the program's line. A result that did not converge comes back: its field status says so.
% SPDX-License-Identifier: GPL-3.0-or-later
  program = getenv('EHD_PROGRAM');
  if isempty(program)
    program = 'ehd';
  end
  command = [quoted(program) ' ' subcommand ' --json -'];
  for k = 1:numel(words)
    word = words{k};
    if isnumeric(word)
      word = sprintf('%.17g', word);
    end
    command = [command ' ' quoted(word)]; %#ok<AGROW>
  end
  complaints = tempname();
  [code, text] = system([command ' 2> ' quoted(complaints)]);
  line = strtrim(fileread(complaints));
  delete(complaints);
  if code > 1 || isempty(text)
    error('ehd:input', '%s', line);
  end
  result = jsondecode(text);
end

function text = quoted(text)
% For the shell: nothing in the text means anything to it.
  text = ['''' strrep(text, '''', '''\''''') ''''];
end
