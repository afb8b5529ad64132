package org.starl.robot.create;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.starl.robot.realtime.RealClock;

/** The guard between a program and its Create, over a line in memory. */
@Tag("realtime")
@Timeout(60)
class WheelGuardTest {

  private static final byte[] STOP = {(byte) 145, 0, 0, 0, 0};
  private static final byte[] PASSIVE = {(byte) 128};
  private static final byte[] SPEEDS = {(byte) 145, 0, 100, 0, 100};
  private static final byte[] MODE = {(byte) 131};
  private static final long SECOND_NS = 1_000_000_000;
  private static final int VALID_MS = 200;

  private final MemoryLink[] line = MemoryLink.pair();
  private final WheelGuard guard = WheelGuard.start(line[0], VALID_MS);
  private final InputStream create = line[1].input();

  /** The bytes of the guard's next write. */
  private byte[] next() throws IOException {
    byte[] bytes = new byte[256];
    int length = create.read(bytes, 0, bytes.length);
    return Arrays.copyOf(bytes, Math.max(0, length));
  }

  private List<byte[]> untilClosed() throws IOException {
    List<byte[]> writes = new ArrayList<>();
    for (byte[] bytes = next(); bytes.length > 0; bytes = next()) {
      writes.add(bytes);
    }
    return writes;
  }

  @Test
  void theWheelsOfASilentProgramStopUntilItWritesAgain() throws IOException {
    for (int i = 0; i < 2; i++) {
      guard.pass(RealClock.machineNs(), SPEEDS);
      assertThat(next()).isEqualTo(SPEEDS);
      assertThat(next()).isEqualTo(STOP);
    }
  }

  @Test
  void oldSpeedsAreDroppedAndTheWheelsStopInstead() throws IOException {
    guard.pass(RealClock.machineNs(), SPEEDS);
    // Behind a stall; a mode has effects only with speeds.
    guard.pass(RealClock.machineNs() - SECOND_NS, SPEEDS);
    guard.pass(RealClock.machineNs() - SECOND_NS, MODE);
    guard.close();

    assertThat(untilClosed()).startsWith(SPEEDS, STOP, MODE);
  }

  @Test
  void oldBytesDoNotCountAsALiveProgram() throws IOException {
    long sentNs = RealClock.machineNs();
    guard.pass(sentNs, SPEEDS);
    byte[] seen = next();
    for (int i = 0; !Arrays.equals(seen, STOP); i++) {
      assertThat(i).as("old bytes without a stop").isLessThan(10_000_000);
      guard.pass(sentNs, MODE);
      seen = next();
    }
  }

  @Test
  void aClosedGuardLeavesTheCreateStandingInPassiveModeAndPassesNothing() throws IOException {
    guard.pass(RealClock.machineNs(), SPEEDS);
    guard.close();
    guard.pass(RealClock.machineNs(), SPEEDS);

    assertThat(untilClosed()).containsExactly(SPEEDS, STOP, PASSIVE, STOP, PASSIVE, STOP, PASSIVE);
  }

  /** A guard that closes waits until the line has taken its last bytes. */
  @Test
  void whileItClosesAGuardPassesNothing() throws Exception {
    Thread closing = new Thread(guard::close);
    closing.start();
    byte[] first = next();
    guard.pass(RealClock.machineNs(), SPEEDS);
    closing.join();

    assertThat(first).startsWith(STOP);
    assertThat(untilClosed()).isNotEmpty().doesNotContain(SPEEDS);
  }

  @Test
  void theBytesOfTheCreateReachTheProgramUntilItsLinkIsOver() throws IOException {
    line[1].output().write("bump".getBytes(StandardCharsets.US_ASCII), 0, 4);
    line[1].close();
    ByteArrayOutputStream program = new ByteArrayOutputStream();

    assertThat(guard.passToProgram(program)).isEqualTo("a line in memory was closed");
    assertThat(program.toString(StandardCharsets.US_ASCII)).isEqualTo("bump");
  }

  @Test
  void aProgramThatTakesNoBytesEndsThePassing() throws IOException {
    line[1].output().write(MODE, 0, 1);

    assertThat(guard.passToProgram(new Broken())).isEqualTo("the robot's program has ended");
    guard.close();
    assertThat(untilClosed()).startsWith(STOP, PASSIVE);
  }

  @Test
  void aLinkThatTakesNoBytesIsClosed() {
    MemoryLink[] other = MemoryLink.pair();
    ByteLink broken = new StreamLink("a cut line", other[0].input(), new Broken(), other[0]);
    WheelGuard cut = WheelGuard.start(broken, VALID_MS);
    cut.pass(RealClock.machineNs(), SPEEDS);

    assertThat(cut.passToProgram(new ByteArrayOutputStream())).isEqualTo("a cut line was closed");
  }

  @Test
  void inPlaceOfAKilledGuardTheWheelsAreStoppedOverALinkThatIsThenClosed() throws IOException {
    WheelGuard.stopWheels(() -> line[0]);

    assertThat(untilClosed()).containsExactly(STOP, STOP, STOP);
  }

  private static final class Broken extends OutputStream {
    @Override
    public void write(int value) throws IOException {
      throw new IOException("cut");
    }
  }
}
