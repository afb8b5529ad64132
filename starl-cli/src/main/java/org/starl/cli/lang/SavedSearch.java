package org.starl.cli.lang;

import java.io.Closeable;
import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.OutputFile;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.lang.check.Checkpoint;
import org.starl.lang.check.Search;

/** The file of {@code starl check --checkpoint}. */
final class SavedSearch implements Closeable {

  private static final String OPTION = "--checkpoint";

  private final String name;
  private final String key;
  private final PrintWriter err;
  private final OutputFile output;
  private final boolean isThere;
  private @Nullable Checkpoint checkpoint;

  /**
   * @param key of what is searched, in one line
   * @param isResumed whether the file may be there
   * @throws BadInput if the file cannot be written, or is there and may not be
   */
  SavedSearch(String name, String key, boolean isResumed, PrintWriter err) {
    this.err = err;
    this.name = name;
    this.key = key;
    isThere = new File(name).exists();
    if (isThere && !isResumed) {
      throw bad("exists already; expected --resume, or another name");
    }
    output = new OutputFile(OPTION, name);
  }

  /**
   * The search is saved if it ends early. It goes on from the file, if that is there.
   *
   * @throws BadInput if the file is damaged, or of something else
   */
  void of(Search search) {
    checkpoint = search.checkpoint();
    if (!isThere) {
      return;
    }
    try {
      String found = Checkpoint.key(Path.of(name));
      if (found.isEmpty()) {
        throw bad("expected a file of 'starl check --checkpoint'");
      }
      if (!found.equals(key)) {
        throw bad("is a search of " + found + "; expected one of " + key);
      }
      checkpoint.read(Path.of(name));
    } catch (IOException e) {
      throw bad("is incomplete or damaged (" + FailureText.of(e) + "); expected another file");
    }
    err.printf("%s: goes on with %,d states%n", name, search.size());
  }

  /** Saves the search, which has ended early. */
  void save() throws IOException {
    if (checkpoint == null || !checkpoint.isMarked()) {
      err.println(name + ": nothing is saved: the start states alone are too many");
      return;
    }
    checkpoint.write(output.stream(), key);
  }

  @Override
  public void close() throws IOException {
    output.close();
    if (output.isWritten()) {
      err.println(name + ": the search is saved; the same command with --resume goes on");
    }
  }

  private BadInput bad(String text) {
    return new BadInput(OPTION + ": " + BadInput.quote(name) + ": " + text);
  }
}
