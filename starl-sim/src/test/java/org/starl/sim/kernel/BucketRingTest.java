package org.starl.sim.kernel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Cells are reused, which the property of the queue does not check. */
class BucketRingTest {

  private static final int EVENTS = 1000;

  private final BucketRing ring = new BucketRing();

  @Test
  void theCellsOfPastBucketsAreReused() {
    int room = 0;
    for (long bucket = 0; bucket < 3L * BucketRing.BUCKETS; bucket += 1000) {
      List<Integer> cells = new ArrayList<>();
      for (int i = 0; i < EVENTS; i++) {
        cells.add(ring.add(bucket, i, i));
      }
      for (int i = 0; i < EVENTS; i += 3) {
        ring.remove(cells.get(i));
      }
      assertThat(takeAll(bucket)).hasSize(EVENTS * 2 / 3).isSorted();
      assertThat(ring.isEmpty()).isTrue();
      room = room == 0 ? ring.room() : room;
    }
    // One bucket is open while the next one is filled.
    assertThat(ring.room()).isLessThanOrEqualTo(2 * room);
  }

  @Test
  void aBucketWhoseEventsWereRemovedIsEmpty() {
    ring.remove(ring.add(5, 0, 7));
    assertThat(ring.isEmpty()).isFalse();
    assertThat(ring.distanceToNext(-1)).isEqualTo(6);
    assertThat(takeAll(5)).isEmpty();
    assertThat(ring.isEmpty()).isTrue();
  }

  @Test
  void anEventCanBeRemovedWhenItsBucketIsOpen() {
    ring.add(5, 10, 7);
    int cell = ring.add(5, 20, 8);
    ring.add(5, 30, 9);
    ring.open(5);
    ring.remove(cell);
    assertThat(ring.slot(0)).isEqualTo(7);
    assertThat(ring.slot(1)).isEqualTo(EventTable.NONE);
    assertThat(ring.slot(2)).isEqualTo(9);
  }

  private List<Integer> takeAll(long bucket) {
    List<Integer> slots = new ArrayList<>();
    for (ring.open(bucket); ring.next() < ring.end(); ring.take()) {
      slots.add(ring.slot(ring.next()));
    }
    return slots;
  }
}
