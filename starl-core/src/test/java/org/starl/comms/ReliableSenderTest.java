package org.starl.comms;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

class ReliableSenderTest {

  private static final RobotId TO = new RobotId("to");

  private final List<Long> transmitted = new ArrayList<>();
  private final List<String> timerCalls = new ArrayList<>();
  private Runnable expiry = () -> {};
  private long nowNs;

  private final ReliableSender sender =
      new ReliableSender(
          () -> nowNs,
          action -> {
            expiry = action;
            return new NotedTimer();
          },
          outgoing -> transmitted.add(outgoing.order));

  private final class NotedTimer implements Timer {
    @Override
    public void set(long atNs) {
      timerCalls.add(atNs == NEVER ? "never" : "set " + atNs / NS_PER_MS);
    }

    @Override
    public void cancel() {
      timerCalls.add("cancel");
    }

    @Override
    public boolean isSet() {
      throw new IllegalStateException("nobody asks");
    }
  }

  private final OpenEndpoint<String> talk = endpoint("talk");

  private static OpenEndpoint<String> endpoint(String kind) {
    Channel<String> channel = new Channel<>(kind, "1", new NoCodec());
    return new OpenEndpoint<>(null, channel, (from, message) -> {});
  }

  private Receipt send() {
    return send(talk);
  }

  private Receipt send(OpenEndpoint<String> endpoint) {
    return sender.send(TO, new RetainedMessage(endpoint, "x", 1, new byte[0]), Reliability.DEFAULT);
  }

  private static final class NoCodec implements Codec<String> {
    @Override
    public void write(String message, WireWriter out) {}

    @Override
    public String read(WireReader in) {
      return "";
    }
  }

  @Test
  void theTimerIsSetToTheNextDueMessageAndCancelledWithoutOne() {
    send();
    nowNs = 100 * NS_PER_MS;
    send();
    sender.acknowledged(TO, 1);
    sender.acknowledged(TO, 2);

    assertThat(timerCalls).containsExactly("set 250", "set 250", "set 350", "never");
  }

  @Test
  void anExpiredTimerIsSetAgain() {
    send();
    nowNs = 250 * NS_PER_MS;
    expiry.run();

    assertThat(timerCalls).containsExactly("set 250", "set 625");
  }

  @Test
  void aMessageIsSettledOnce() {
    send(); // keeps the window open
    send();
    assertThat(sender.acknowledged(TO, 2)).isTrue();
    assertThat(sender.acknowledged(TO, 2)).as("again").isFalse();
  }

  /** Messages that wait for room in the window follow when the ones before them have failed. */
  @Test
  void messagesThatAreHeldBackFollowWhenAnEndpointCloses() {
    OpenEndpoint<String> other = endpoint("other");
    for (int i = 0; i < InboundWindows.WINDOW; i++) {
      send(other);
    }
    send();
    long last = InboundWindows.WINDOW + 1;
    assertThat(transmitted).doesNotContain(last);
    sender.fail(other);
    assertThat(transmitted).contains(last);
  }
}
