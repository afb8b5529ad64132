package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Lines that strangers cause, in virtual time. */
class LimitedLogTest {

  private static final long MS = 1_000_000;

  private final List<String> lines = new ArrayList<>();
  private long nowNs;
  private final LimitedLog log = new LimitedLog(() -> nowNs, lines::add);

  @Test
  void eachKindHasOneLineASecondWithTheNumberOfThoseLeftOut() {
    for (int i = 0; i <= 2500; i++) {
      nowNs = i * MS;
      log.log("a", "a" + i);
    }
    log.log("b", "b");
    assertThat(lines)
        .containsExactly("a0", "a1000 (and 999 before it)", "a2000 (and 999 before it)", "b");
  }
}
