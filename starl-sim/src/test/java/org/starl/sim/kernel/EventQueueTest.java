package org.starl.sim.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** The queue against a sorted list. */
class EventQueueTest {

  private static final long BUCKET_NS = 1 << 16;
  private static final long RING_NS = BUCKET_NS << 15;
  private static final long HOUR_NS = 3_600_000_000_000L;

  @Property(tries = 2000)
  void eventsComeInTheOrderOfASortedList(@ForAll("programs") List<Step> program) {
    Both both = new Both();
    for (Step step : program) {
      switch (step.what) {
        case ADD -> both.add(step.aheadNs);
        case REMOVE -> both.remove(step.index);
        case POLL -> both.poll(both.nowNs + step.aheadNs);
        default -> throw new IllegalStateException();
      }
    }
    while (both.poll(Long.MAX_VALUE)) {
      assertThat(both.queue.size()).isEqualTo(both.model.size());
    }
    assertThat(both.model).isEmpty();
  }

  @Property(tries = 200)
  void eventsOfEqualTimeComeInSchedulingOrder(@ForAll("aheadNs") long atNs) {
    Both both = new Both();
    for (int i = 0; i < 200; i++) {
      both.add(atNs);
    }
    while (both.poll(Long.MAX_VALUE)) {
      if (both.nowNs == atNs && both.made < 300) {
        both.add(0);
      }
    }
    assertThat(both.model).isEmpty();
  }

  @Example
  void aRemovedEventIsReleased() {
    for (long aheadNs : new long[] {0, 5, BUCKET_NS, RING_NS - 1, RING_NS, HOUR_NS}) {
      EventQueue queue = new EventQueue();
      List<Integer> slots = new ArrayList<>();
      for (int i = 0; i < 1000; i++) {
        int slot = queue.add(aheadNs, null, () -> {});
        queue.remove(slot);
        slots.add(slot);
      }
      assertThat(slots).containsOnly(slots.get(0));
      assertThat(queue.size()).isZero();
      assertThat(queue.poll(Long.MAX_VALUE)).isFalse();
    }
  }

  @Example
  void anEventAtTheLastInstantIsDelivered() {
    EventQueue queue = new EventQueue();
    queue.add(Long.MAX_VALUE, null, () -> {});
    queue.add(3 * HOUR_NS, null, () -> {});
    assertThat(queue.poll(Long.MAX_VALUE)).isTrue();
    assertThat(queue.atNs()).isEqualTo(3 * HOUR_NS);
    assertThat(queue.poll(Long.MAX_VALUE - 1)).isFalse();
    assertThat(queue.poll(Long.MAX_VALUE)).isTrue();
    assertThat(queue.atNs()).isEqualTo(Long.MAX_VALUE);
  }

  @Provide
  Arbitrary<List<Step>> programs() {
    return Combinators.combine(
            Arbitraries.of(What.ADD, What.ADD, What.REMOVE, What.POLL),
            aheadNs(),
            Arbitraries.integers().between(0, 1000))
        .as(Step::new)
        .list()
        .ofMaxSize(300);
  }

  @Provide
  Arbitrary<Long> aheadNs() {
    return Arbitraries.oneOf(
        Arbitraries.of(
            0L, 1L, BUCKET_NS - 1, BUCKET_NS, RING_NS - BUCKET_NS, RING_NS - 1, RING_NS, HOUR_NS),
        Arbitraries.longs().between(0, 3 * BUCKET_NS),
        Arbitraries.longs().between(0, RING_NS / 10),
        Arbitraries.longs().between(RING_NS - 2 * BUCKET_NS, RING_NS + 2 * BUCKET_NS),
        Arbitraries.longs().between(0, HOUR_NS));
  }

  private enum What {
    ADD,
    REMOVE,
    POLL
  }

  private record Step(What what, long aheadNs, int index) {}

  /** A piece that knows its place in the total order. */
  private record Event(long atNs, int number, int[] slot) implements Runnable {
    @Override
    public void run() {}
  }

  /** The queue and the list, always in step. */
  private static final class Both {
    private static final Comparator<Event> ORDER =
        Comparator.comparingLong(Event::atNs).thenComparingInt(Event::number);

    private final EventQueue queue = new EventQueue();
    private final List<Event> model = new ArrayList<>();
    private long nowNs;
    private int made;

    void add(long aheadNs) {
      Event event = new Event(nowNs + aheadNs, made++, new int[1]);
      event.slot[0] = queue.add(event.atNs, null, event);
      model.add(event);
    }

    void remove(int index) {
      if (!model.isEmpty()) {
        Event event = model.remove(index % model.size());
        queue.remove(event.slot[0]);
      }
    }

    boolean poll(long untilNs) {
      Event expected = model.stream().min(ORDER).filter(e -> e.atNs <= untilNs).orElse(null);
      boolean polled = queue.poll(untilNs);
      assertThat(polled).isEqualTo(expected != null);
      if (expected != null) {
        assertThat(queue.piece()).isSameAs(expected);
        assertThat(queue.atNs()).isEqualTo(expected.atNs);
        model.remove(expected);
        nowNs = expected.atNs;
      }
      return polled;
    }
  }
}
