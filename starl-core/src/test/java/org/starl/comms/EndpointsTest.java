package org.starl.comms;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.testing.FakeWorld;

/** Channels that open and close between messages, against one slot a channel. */
class EndpointsTest {

  private static final RobotId RECEIVER = new RobotId("b");
  private static final int CHANNELS = 6;
  private static final int STEPS = 60;

  private final List<String> heard = new ArrayList<>();

  @Property(tries = 200)
  void aMessageArrivesIfItsChannelIsOpen(@ForAll long seed) {
    Rng rng = new Rng(seed);
    FakeWorld world = new FakeWorld("a", "b");
    Comms sender = new Comms(world.boot("a").platform(), 1);
    Comms receiver = new Comms(world.boot("b").platform(), 1);
    List<Endpoint<Integer>> outs = new ArrayList<>();
    @Nullable Endpoint<?>[] ins = new Endpoint<?>[CHANNELS];
    for (int i = 0; i < CHANNELS; i++) {
      outs.add(sender.open(channel(i), (from, message) -> {}));
    }
    List<String> expected = new ArrayList<>();
    long unheard = 0;
    heard.clear();
    for (int step = 0; step < STEPS; step++) {
      int at = rng.nextInt(CHANNELS);
      Endpoint<?> open = ins[at];
      if (rng.nextBoolean(0.6)) {
        outs.get(at).send(RECEIVER, step);
        world.runMs(10);
        if (open == null) {
          unheard++;
        } else {
          expected.add(at + ": " + step);
        }
      } else if (open == null) {
        ins[at] = receiver.open(channel(at), (from, message) -> heard.add(at + ": " + message));
      } else {
        open.close();
        ins[at] = null;
      }
    }
    assertThat(heard).isEqualTo(expected);
    assertThat(receiver.dropped(DropReason.NO_LISTENER)).isEqualTo(unheard);
  }

  private static Channel<Integer> channel(int index) {
    return new Channel<>("talk", String.valueOf(index), new Number());
  }

  private static final class Number implements Codec<Integer> {
    @Override
    public void write(Integer message, WireWriter out) {
      out.i32(message);
    }

    @Override
    public Integer read(WireReader in) {
      return in.i32();
    }
  }
}
