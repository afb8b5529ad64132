package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.cli.command.ExitStatus;

/** Commands in folders and locales of all kinds: the right result, or one line. */
@Tag("realtime")
class PlacesTest {

  @TempDir private Path folder;

  private record Ended(int status, String err) {}

  /** Runs a command in {@code place}; {@code to} gets its output. */
  private static Ended run(Path place, String locale, String to, String words)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of("sh", "-c", "exec \"$@\" >" + to, "sh"));
    command.addAll(Cli.process(words.split(" ")));
    ProcessBuilder builder = new ProcessBuilder(command).directory(place.toFile());
    builder.environment().put("LC_ALL", locale);
    builder.environment().put("HOME", "/proc"); // Nothing can be written there.
    Process process = builder.start();
    String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
    return new Ended(process.waitFor(), err);
  }

  private static List<String> files(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "run hello --seed 1",
        "campaign hello --seeds 1..2",
        "record hello --png",
        "verify-determinism hello --seed 1",
        "explore election --seed 1 --schedules 1",
        "keygen robot.key",
        "completion bash",
        "new robots",
        "list"
      })
  void aFolderIsFoundOrRefused(String words) throws IOException, InterruptedException {
    Path place = Files.createDirectories(folder.resolve("a b/\u00F6 \u65E5\u672C"));
    Ended ascii = run(place, "C", "/dev/null", words);
    assertThat(ascii.err()).hasLineCount(1).contains("expected LC_ALL=C.UTF-8");
    assertThat(ascii.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(files(place)).isEmpty();
    Ended utf8 = run(place, "C.UTF-8", "/dev/null", words);
    assertThat(utf8.status()).as(utf8.err()).isZero();
    assertThat(files(place.getParent())).containsExactly("\u00F6 \u65E5\u672C");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "run hello --seed 1",
        "campaign hello --seeds 1..2",
        "explore election --seed 1 --schedules 1",
        "verify-determinism hello --seed 1",
        "completion bash",
        "help run",
        "list",
        "schema"
      })
  void aFullDiskIsToldInOneLine(String words) throws IOException, InterruptedException {
    assumeTrue(Files.isWritable(Path.of("/dev/full")), "skipped: no /dev/full here");
    Ended full = run(folder, "C.UTF-8", "/dev/full", words);
    assertThat(full.status()).as(full.err()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(full.err().lines()).last().asString().contains("standard output cannot be written");
  }
}
