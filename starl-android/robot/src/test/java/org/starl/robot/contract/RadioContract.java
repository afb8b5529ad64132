package org.starl.robot.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.platform.Timer;

/** What every {@link Radio} does, on a network that loses a datagram now and then at most. */
public abstract class RadioContract {

  private static final long RETRY_NS = 20_000_000;
  private static final RobotId STRANGER = new RobotId("stranger");

  private final List<String> log = new CopyOnWriteArrayList<>();
  private Air air;

  /** Robots {@code robot0}, {@code robot1}, {@code robot2} in reach of each other. */
  public interface Air extends AutoCloseable {

    int ROBOTS = 3;

    Ground ground(int robot);

    Radio radio(int robot);

    /** Takes a robot's radio off the air; from outside, or on its strand. */
    void closeRadio(int robot);

    @Override
    void close();
  }

  protected abstract Air newAir();

  @BeforeEach
  void begin() {
    air = newAir();
  }

  @AfterEach
  void end() {
    air.close();
    for (int robot = 0; robot < Air.ROBOTS; robot++) {
      assertThat(air.ground(robot).errors()).isEmpty();
    }
  }

  @Test
  void aDatagramArrivesOnTheReceiversStrandAsItWasSent() {
    CountDownLatch done = new CountDownLatch(1);
    receive(1, done);
    sendUntil(done, radio -> send(radio, id(1), "hello"));
    assertThat(log).contains("robot1 hears hello").doesNotContain("robot2 hears hello");
  }

  @Test
  void aBroadcastArrivesAtEveryOtherRobot() {
    CountDownLatch done = new CountDownLatch(2);
    receive(0, new CountDownLatch(1));
    receive(1, done);
    receive(2, done);
    sendUntil(done, radio -> broadcast(radio, "all"));
    assertThat(log).contains("robot1 hears all", "robot2 hears all");
    assertThat(log).doesNotContain("robot0 hears all");
  }

  @Test
  void noDatagramArrivesInsideTheCallThatSendsIt() {
    CountDownLatch done = new CountDownLatch(1);
    CountDownLatch heard = new CountDownLatch(1);
    receive(1, heard);
    air.ground(1)
        .strand()
        .post(() -> {
          send(air.radio(1), id(1), "self");
          log.add("sent");
          done.countDown();
        });
    air.ground(1).runUntil(done);
    assertThat(log).startsWith("sent");
  }

  @Test
  void theCallerMayReuseItsBuffer() {
    CountDownLatch done = new CountDownLatch(1);
    receive(1, done);
    byte[] buffer = new byte[Radio.MAX_BYTES + 10];
    sendUntil(
        done,
        radio -> {
          Arrays.fill(buffer, (byte) 'a');
          radio.send(id(1), buffer, 3);
          Arrays.fill(buffer, (byte) 'b');
        });
    assertThat(log).containsOnly("robot1 hears aaa");
  }

  @Test
  void theLongestAndTheShortestDatagramArrive() {
    CountDownLatch done = new CountDownLatch(1);
    List<Integer> lengths = new CopyOnWriteArrayList<>();
    onStrand(
        1,
        () ->
            air.radio(1)
                .onReceive((buffer, length) -> {
                  lengths.add(length);
                  if (lengths.contains(0) && lengths.contains(Radio.MAX_BYTES)) {
                    done.countDown();
                  }
                }));
    sendUntil(
        done,
        radio -> {
          radio.send(id(1), new byte[Radio.MAX_BYTES], Radio.MAX_BYTES);
          radio.send(id(1), new byte[0], 0);
        });
    assertThat(lengths).containsOnly(Radio.MAX_BYTES, 0);
  }

  @Test
  void aDatagramThatIsTooLongIsABug() {
    onStrand(
        0,
        () -> {
          byte[] buffer = new byte[2 * Radio.MAX_BYTES];
          assertThatThrownBy(() -> air.radio(0).send(id(1), buffer, Radio.MAX_BYTES + 1))
              .isInstanceOf(IllegalArgumentException.class)
              .hasMessageContaining(String.valueOf(Radio.MAX_BYTES + 1));
          assertThatThrownBy(() -> air.radio(0).broadcast(buffer, -1))
              .isInstanceOf(IllegalArgumentException.class);
          assertThatThrownBy(() -> air.radio(0).broadcast(new byte[2], 3))
              .isInstanceOf(IllegalArgumentException.class);
        });
  }

  @Test
  void aDatagramToAnUnknownRobotIsLost() {
    CountDownLatch done = new CountDownLatch(1);
    receive(1, done);
    sendUntil(
        done,
        radio -> {
          send(radio, STRANGER, "anybody");
          send(radio, id(1), "after");
        });
    assertThat(log).contains("robot1 hears after").doesNotContain("robot1 hears anybody");
  }

  @Test
  void aSecondReceiverOfDatagramsIsRefused() {
    onStrand(
        0,
        () -> {
          air.radio(0).onReceive((buffer, length) -> {});
          assertThatThrownBy(() -> air.radio(0).onReceive((buffer, length) -> {}))
              .isInstanceOf(IllegalStateException.class)
              .hasMessageContaining("robot0");
        });
  }

  @Test
  void aClosedRadioNeitherSendsNorReceives() {
    CountDownLatch heard = new CountDownLatch(1);
    CountDownLatch done = new CountDownLatch(1);
    receive(1, heard);
    receive(2, done);
    onStrand(1, () -> air.closeRadio(1));
    onStrand(1, () -> send(air.radio(1), id(2), "from the dead"));
    sendUntil(
        done,
        radio -> {
          send(radio, id(1), "to the dead");
          send(radio, id(2), "to the living");
        });
    assertThat(log).contains("robot2 hears to the living");
    assertThat(log).doesNotContain("robot1 hears to the dead", "robot2 hears from the dead");
  }

  private void receive(int robot, CountDownLatch heard) {
    onStrand(
        robot,
        () ->
            air.radio(robot)
                .onReceive((buffer, length) -> {
                  assertThat(air.ground(robot).strand().isCurrent()).isTrue();
                  String text = new String(buffer, 0, length, StandardCharsets.UTF_8);
                  if (!log.contains(id(robot) + " hears " + text)) {
                    log.add(id(robot) + " hears " + text);
                    heard.countDown();
                  }
                }));
  }

  /** Lets robot0 send, again and again: a datagram may be lost. */
  private void sendUntil(CountDownLatch done, Consumer<Radio> sending) {
    Ground ground = air.ground(0);
    Timer[] retry = new Timer[1];
    retry[0] =
        ground
            .timers()
            .timer(() -> {
              sending.accept(air.radio(0));
              retry[0].set(ground.clock().nowNs() + RETRY_NS);
            });
    ground.strand().post(() -> retry[0].set(0));
    ground.runUntil(done);
  }

  private void onStrand(int robot, Runnable piece) {
    CountDownLatch done = new CountDownLatch(1);
    Ground ground = air.ground(robot);
    ground
        .strand()
        .post(() -> {
          piece.run();
          done.countDown();
        });
    ground.runUntil(done);
  }

  private static void send(Radio radio, RobotId to, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    radio.send(to, bytes, bytes.length);
  }

  private static void broadcast(Radio radio, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    radio.broadcast(bytes, bytes.length);
  }

  protected static RobotId id(int robot) {
    return new RobotId("robot" + robot);
  }
}
