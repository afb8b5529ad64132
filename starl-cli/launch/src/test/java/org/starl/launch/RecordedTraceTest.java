package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.robot.DeployedRobot;
import org.starl.robot.trace.ProcessFact;
import org.starl.robot.trace.ProcessTrace;
import org.starl.sim.Simulation;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent.Action;

class RecordedTraceTest {

  private static final RobotId BOT0 = new RobotId("bot0");

  @TempDir private Path folder;
  private Path file = Path.of("");

  @BeforeEach
  void write() throws IOException {
    file = folder.resolve("bot0.trace");
    try (OutputStream out = Files.newOutputStream(file)) {
      ProcessTrace trace =
          new ProcessTrace(BOT0, Simulation.builder().build().plan().header(), out);
      trace.report(() -> 0, new ProcessFact.Clock("machine", 1, 2));
      for (long atNs = 1; atNs <= 3; atNs++) {
        trace.record(Action.of(atNs, BOT0, Instance.APP, Note.SHAPE, new Note("walks", List.of())));
      }
      trace.end(3);
    }
  }

  private RecordedTrace read() {
    return RecordedTrace.read(file.toString(), header -> DeployedRobot.VOCABULARY);
  }

  private void change(int line, String to) throws IOException {
    List<String> lines = new ArrayList<>(Files.readAllLines(file));
    lines.set(line - 1, to);
    Files.writeString(file, String.join("\n", lines) + "\n");
  }

  @Test
  void aTraceWithAnEndIsComplete() {
    assertThat(read().isComplete()).isTrue();
    assertThat(read().events()).hasSize(3);
  }

  @Test
  void aTraceCutInItsLastLineKeepsTheLinesBefore() throws IOException {
    String all = Files.readString(file);
    int third = all.lastIndexOf("walks");
    for (int cut : new int[] {third, third - 10, all.indexOf('\n', third) + 1}) {
      Files.writeString(file, all.substring(0, cut));

      assertThat(read().isComplete()).isFalse();
      assertThat(read().events()).hasSizeBetween(2, 3);
    }
  }

  @Test
  void aWrongLineBeforeTheLastIsRefused() throws IOException {
    change(4, "{\"kind\":\"act");

    assertThatThrownBy(this::read).isInstanceOf(BadInput.class).hasMessageContaining(file + ":4");
  }

  @Test
  void aLineAfterTheEndIsRefused() throws IOException {
    Files.writeString(file, Files.readString(file) + "more\n");

    assertThatThrownBy(this::read).isInstanceOf(BadInput.class).hasMessageContaining(file + ":7");
  }
}
