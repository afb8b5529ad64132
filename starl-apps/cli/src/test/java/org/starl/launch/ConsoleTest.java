package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The output of a robot's process. */
@Tag("realtime")
class ConsoleTest {

  private static final int LINES = 20_000;
  private static final String TEXT = "x".repeat(100);

  @Test
  void aPipeThatNothingReadsBlocksNoRobotAndLostLinesAreCounted() throws Exception {
    Process reader = new ProcessBuilder("cat").start();
    signal(reader, "-STOP");
    try (PrintStream pipe = new PrintStream(reader.getOutputStream(), true)) {
      Console console = new Console(pipe::println);
      for (int i = 0; i < LINES; i++) {
        console.accept(TEXT);
      }
      console.close();
      assertThat(console.isStuck()).isTrue();

      signal(reader, "-CONT");
      try (BufferedReader out =
          new BufferedReader(
              new InputStreamReader(reader.getInputStream(), StandardCharsets.UTF_8))) {
        long lost = 0;
        for (long told = 0; told < LINES; told++) {
          String line = out.readLine();
          if (!line.equals(TEXT)) {
            assertThat(line).endsWith("lines were lost here, because the output was blocked");
            lost = Long.parseLong(line.substring(0, line.indexOf(' ')));
            told += lost - 1;
          }
        }
        assertThat(lost).isPositive();
      }
    } finally {
      reader.destroyForcibly();
    }
  }

  private static void signal(Process process, String name) throws Exception {
    new ProcessBuilder("kill", name, Long.toString(process.pid())).start().waitFor();
  }

  @Test
  void closingPrintsAllLinesInOrder() {
    List<String> printed = new CopyOnWriteArrayList<>();
    Console console = new Console(printed::add);
    console.accept("one");
    console.accept("");
    console.accept("two");
    console.close();
    assertThat(printed).containsExactly("one", "", "two");
    assertThat(console.isStuck()).isFalse();
  }
}
