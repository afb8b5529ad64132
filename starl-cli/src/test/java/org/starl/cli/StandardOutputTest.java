package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A standard output that cannot be written is told; no result is lost in silence. */
class StandardOutputTest {

  private static final class Full extends OutputStream {
    @Override
    public void write(int b) throws IOException {
      throw new IOException("No space left on device");
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--help",
        "--version",
        "help run",
        "list",
        "list hello --json",
        "run hello --seed 1 --png /dev/null",
        "run hello --seed 1 --json --png /dev/null",
        "campaign hello --seeds 1..2",
        "record hello --seed 1 --out /dev/null",
        "verify-determinism hello --seed 1",
        "schema",
        "completion bash"
      })
  void isToldInALine(String words) {
    StringWriter err = new StringWriter();
    int status =
        Main.run(Main.ALL, new PrintWriter(new Full()), new PrintWriter(err), words.split(" "));
    assertThat(status).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString().lines().filter(line -> line.startsWith("starl: ")))
        .containsExactly(
            "starl: standard output cannot be written; expected a file or a pipe with room");
  }
}
