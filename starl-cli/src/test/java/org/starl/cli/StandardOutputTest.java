package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.cli.command.Apps;
import org.starl.cli.command.ExitStatus;

/** A standard output that cannot be written is told; no result is lost in silence. */
class StandardOutputTest {

  private static final class Full extends OutputStream {
    @Override
    public void write(int b) throws IOException {
      throw new IOException("No space left on device");
    }
  }

  /** As in {@code starl list | head -1}, whose reader has ended. */
  @Tag("realtime")
  @ParameterizedTest
  @ValueSource(
      strings = {
        "--help",
        "list hello",
        "list hello --json",
        "run hello --seed 1 --png /dev/null",
        "campaign hello --seeds 1..2",
        "schema",
        "completion bash"
      })
  void endsQuietlyWhenItsReaderHasEnded(String words) throws Exception {
    Process process = new ProcessBuilder(Cli.process(words.split(" "))).start();
    process.getInputStream().close();
    try (BufferedReader err = process.errorReader()) {
      assertThat(err.lines())
          .noneMatch(line -> line.contains("cannot be written") || line.startsWith("\tat "));
    }
    assertThat(process.waitFor()).isEqualTo(StandardOutput.STATUS);
  }

  @Tag("realtime")
  @Test
  void hasTheDigitsOfEveryLanguage() throws Exception {
    ProcessBuilder builder =
        new ProcessBuilder(Cli.process("campaign", "hello", "--seeds", "1..2"));
    builder.environment().put("JAVA_TOOL_OPTIONS", "-Duser.language=ar -Duser.country=EG");
    Process process = builder.start();
    try (BufferedReader out = process.inputReader(StandardCharsets.UTF_8)) {
      assertThat(out.lines()).anyMatch(line -> line.startsWith("bad runs: 0 of 2: "));
    }
    assertThat(process.waitFor()).isZero();
  }

  @Tag("realtime")
  @Test
  void helpFitsTheTerminal() throws Exception {
    ProcessBuilder builder = new ProcessBuilder(Cli.process("help"));
    builder.environment().put("COLUMNS", "60");
    Process process = builder.start();
    try (BufferedReader out = process.inputReader(StandardCharsets.UTF_8)) {
      assertThat(out.lines()).isNotEmpty().allMatch(line -> line.length() <= 60);
    }
    assertThat(process.waitFor()).isZero();
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
        Main.run(Apps.ALL, new PrintWriter(new Full()), new PrintWriter(err), words.split(" "));
    assertThat(status).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString().lines().filter(line -> line.startsWith("starl: ")))
        .containsExactly(
            "starl: standard output cannot be written; expected a file or a pipe with room");
  }
}
