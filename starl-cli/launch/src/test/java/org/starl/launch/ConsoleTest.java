package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CompletableFuture;
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
    try (PrintStream pipe = new PrintStream(reader.getOutputStream(), true)) {
      try {
        signal(reader, "-STOP");
        losesLines(reader, pipe);
      } finally {
        // Before the pipe is closed, which would wait for a blocked write.
        reader.destroyForcibly();
      }
    }
  }

  private static void losesLines(Process reader, PrintStream pipe) throws Exception {
    Console console = new Console(pipe::println);
    for (int i = 0; i < LINES; i++) {
      console.accept(TEXT);
    }
    console.close();
    assertThat(console.isStuck()).isTrue();

    signal(reader, "-CONT");
    CompletableFuture<Void> closed = CompletableFuture.runAsync(() -> closeAfter(console, pipe));
    long told = 0;
    long lost = 0;
    try (BufferedReader out =
        new BufferedReader(
            new InputStreamReader(reader.getInputStream(), StandardCharsets.UTF_8))) {
      for (String line = out.readLine(); line != null; line = out.readLine()) {
        if (line.equals(TEXT)) {
          told++;
        } else {
          assertThat(line).endsWith("lines were lost here, because the output was blocked");
          lost += Long.parseLong(line.substring(0, line.indexOf(' ')));
        }
      }
    }
    closed.join();
    assertThat(lost).isPositive();
    assertThat(told + lost).isEqualTo(LINES);
  }

  private static void closeAfter(Console console, PrintStream pipe) {
    while (console.isStuck()) {
      console.close();
    }
    pipe.close();
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
