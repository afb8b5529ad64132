package org.starl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.TreeMap;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.platform.StableStorage;
import org.starl.shape.Shapes;

class PersistentTest {

  /** A disc that a test flushes, write by write. */
  private static final class Disc implements StableStorage {
    private final Map<String, byte[]> written = new TreeMap<>();
    private final Map<String, byte[]> kept = new TreeMap<>();
    private final Queue<Runnable> pending = new ArrayDeque<>();

    @Override
    public byte @Nullable [] get(String key) {
      return written.get(key);
    }

    @Override
    public void put(String key, byte[] value, Runnable flushed) {
      written.put(key, value);
      pending.add(() -> {
        kept.put(key, value);
        flushed.run();
      });
    }

    @Override
    public void remove(String key) {
      throw new UnsupportedOperationException();
    }

    void flush() {
      pending.remove().run();
    }

    void crash() {
      pending.clear();
      written.clear();
      written.putAll(kept);
    }
  }

  private final Disc disc = new Disc();

  private Persistent<Long> open() {
    return new Persistent<>(disc, "count", Shapes.LONG, -1L);
  }

  @Property(tries = 100, edgeCases = EdgeCasesMode.NONE)
  void aCrashKeepsWhatWasFlushed(@ForAll @Size(max = 9) List<Long> values, @ForAll byte upTo) {
    disc.crash();
    disc.kept.clear();
    disc.written.clear();
    int flushes = Math.floorMod(upTo, values.size() + 1);
    Persistent<Long> variable = open();
    List<Long> told = new ArrayList<>();
    for (long value : values) {
      variable.set(value, () -> told.add(value));
      assertThat(variable.get()).isEqualTo(value);
    }
    for (int i = 0; i < flushes; i++) {
      disc.flush();
    }
    assertThat(told).isEqualTo(values.subList(0, flushes));
    assertThat(variable.isFlushed()).isEqualTo(flushes == values.size());
    disc.crash();
    assertThat(open().get()).isEqualTo(flushes == 0 ? -1 : values.get(flushes - 1));
  }

  @Test
  void bytesOfAnotherShapeAreToldByName() {
    disc.written.put("count", new byte[3]);
    assertThatThrownBy(this::open)
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("'count': expected i64");
  }

  @Test
  void aValueThatTheShapeRefusesChangesNothing() {
    Persistent<Integer> small = new Persistent<>(disc, "small", Shapes.U8, 7);
    assertThatThrownBy(() -> small.set(300)).isInstanceOf(IllegalArgumentException.class);
    assertThat(small.get()).isEqualTo(7);
    assertThat(small.isFlushed()).isTrue();
  }
}
