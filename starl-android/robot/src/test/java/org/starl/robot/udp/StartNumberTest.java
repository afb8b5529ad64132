package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.platform.StableStorage;

class StartNumberTest {

  private final Map<String, byte[]> written = new TreeMap<>();

  private final StableStorage stable =
      new StableStorage() {
        @Override
        public byte @Nullable [] get(String key) {
          return written.get(key);
        }

        @Override
        public void put(String key, byte[] value, Runnable flushed) {
          written.put(key, value);
        }

        @Override
        public void remove(String key) {
          written.remove(key);
        }
      };

  @Test
  void startNumbersIncreaseEvenIfTheDateGoesBack() {
    assertThat(StartNumber.next(stable, 1000)).isEqualTo(1000);
    assertThat(StartNumber.next(stable, 2000)).isEqualTo(2000);
    assertThat(StartNumber.next(stable, 5)).isEqualTo(2001);
    assertThat(StartNumber.next(stable, 6)).isEqualTo(2002);
    assertThat(StartNumber.next(stable, 3000)).isEqualTo(3000);
  }

  @Test
  void afterALossOfStorageTheStartNumberComesFromTheDate() {
    StartNumber.next(stable, 1000);
    written.clear();
    assertThat(StartNumber.next(stable, 1001)).isEqualTo(1001);

    written.replaceAll((key, value) -> new byte[3]);
    assertThat(StartNumber.next(stable, 1002)).isEqualTo(1002);
  }
}
