package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.StreamLink;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Wheels;
import org.starl.robot.serial.PseudoTerminal;

/** The process between a robot's program and its wheels. */
@Tag("realtime")
class GuardProcessTest {

  private static final byte[] STOP = {(byte) 145, 0, 0, 0, 0};
  private static final byte[] PASSIVE = {(byte) 128};

  private static final Limits LIMITS = new Limits(300, 300, 500, 0.1, 200);

  /** A longer wait means that it never happens. */
  private static final int LIMIT_MS = 60_000;

  @Test
  void bytesPassBothWaysAndTheWheelsStopWhenTheProgramEnds() throws Exception {
    try (Ends ends = new Ends()) {
      ends.drive();
      ends.line.getOutputStream().write("bump".getBytes(StandardCharsets.US_ASCII));

      assertThat(ends.program.input().readNBytes(4))
          .asString(StandardCharsets.US_ASCII)
          .isEqualTo("bump");

      // As the end of the program's process does.
      ends.program.output().close();

      assertThat(ends.line.getInputStream().readAllBytes()).startsWith(STOP).endsWith(PASSIVE);
    }
  }

  @Test
  void theWheelsOfASilentProgramStopUntilItWritesAgain() throws Exception {
    try (Ends ends = new Ends()) {
      // Like a frozen program: it writes nothing, and its end stays open.
      ends.drive();

      assertThat(ends.line.getInputStream().readNBytes(STOP.length)).isEqualTo(STOP);
      ends.drive();
    }
  }

  @Test
  void aFrozenGuardIsKilledWhenItsProgramClosesTheLink() throws Exception {
    try (Ends ends = new Ends()) {
      ends.drive();
      new ProcessBuilder("kill", "-STOP", Long.toString(ends.guard.pid())).start().waitFor();

      // So the wheels cannot be stopped over it.
      ends.create.close();

      assertThatThrownBy(ends.program::close).isInstanceOf(IOException.class);

      assertThat(ends.guard.onExit().get(LIMIT_MS, TimeUnit.MILLISECONDS).isAlive()).isFalse();
    }
  }

  /** A shutdown also closes the ports. */
  @Test
  void aGuardThatIsToldToEndStopsTheWheelsOverItsPortFirst() throws Exception {
    try (StreamLink create = PseudoTerminal.open("")) {
      Set<ProcessHandle> before = Ends.children();
      ByteLink program =
          GuardProcess.links(new Wheels.Device(create.name()), 115_200, LIMITS).open();
      ProcessHandle guard =
          Ends.children().stream().filter(child -> !before.contains(child)).findAny().orElseThrow();
      program.output().write("drive".getBytes(StandardCharsets.US_ASCII));
      program.output().flush();
      assertThat(create.input().readNBytes(5))
          .asString(StandardCharsets.US_ASCII)
          .isEqualTo("drive");
      guard.destroy();

      assertThat(guard.onExit().get(LIMIT_MS, TimeUnit.MILLISECONDS).isAlive()).isFalse();
      // Perhaps a stop for the silence, and three times a stop and passive mode.
      byte[] rest = create.input().readNBytes(3 * (STOP.length + PASSIVE.length));
      assertThat(rest).startsWith(STOP).contains(PASSIVE);
      program.close();
    }
  }

  @Test
  void theWheelsStopBeforeAKilledGuardIsReplaced() throws Exception {
    try (ServerSocket create = new ServerSocket(0, 2, InetAddress.getLoopbackAddress())) {
      HostPort address = new HostPort("127.0.0.1", create.getLocalPort());
      ByteLink program = GuardProcess.links(new Wheels.Tcp(address), 115_200, LIMITS).open();
      ProcessHandle guard = ProcessHandle.current().children().reduce((a, b) -> b).orElseThrow();
      try (Socket first = create.accept()) {
        guard.destroyForcibly();
        assertThat(first.getInputStream().read()).isEqualTo(-1);
      }
      program.close();
      create.setSoTimeout(LIMIT_MS);
      try (Socket second = create.accept()) {
        assertThat(second.getInputStream().readAllBytes()).startsWith(STOP).endsWith(STOP);
      }
    }
  }

  @Test
  void aPortThatCannotBeOpenedIsNamed() throws Exception {
    ByteLink program =
        GuardProcess.links(new Wheels.Device("/dev/no-such-port"), 115_200, LIMITS).open();

    assertThatThrownBy(() -> program.input().read())
        .isInstanceOf(IOException.class)
        .hasMessageContaining("/dev/no-such-port");
    program.close();
  }

  /** A guard with the program at one end and the Create at the other. */
  private static final class Ends implements AutoCloseable {
    // Open until the end: a slow machine may kill a slow guard, and then the wheels are stopped
    // over it.
    private final ServerSocket create;
    private final ByteLink program;
    private final ProcessHandle guard;
    private final Socket line;

    Ends() throws IOException {
      create = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
      HostPort address = new HostPort("127.0.0.1", create.getLocalPort());
      Set<ProcessHandle> before = children();
      program = GuardProcess.links(new Wheels.Tcp(address), 115_200, LIMITS).open();
      Set<ProcessHandle> now = children();
      now.removeAll(before);
      guard = now.iterator().next();
      line = create.accept();
      line.setSoTimeout(LIMIT_MS);
    }

    static Set<ProcessHandle> children() {
      return ProcessHandle.current().children().collect(Collectors.toCollection(HashSet::new));
    }

    /** The program writes a word, and the Create receives it. */
    void drive() throws IOException {
      program.output().write("drive".getBytes(StandardCharsets.US_ASCII));
      program.output().flush();
      assertThat(line.getInputStream().readNBytes(5))
          .asString(StandardCharsets.US_ASCII)
          .isEqualTo("drive");
    }

    @Override
    public void close() throws IOException {
      line.close();
      program.close();
      create.close();
    }
  }
}
