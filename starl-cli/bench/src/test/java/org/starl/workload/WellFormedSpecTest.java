package org.starl.workload;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/** The specification on handwritten traces. */
class WellFormedSpecTest {

  private static final RobotId BOT = new RobotId("bot0");

  private final Monitors monitors = new Monitors(List.of(new WellFormedSpec()));

  private void drop(String why) {
    monitors.observe(new TraceEvent.Dropped(1, BOT, "bot1", why));
  }

  @Test
  void aPayloadThatItsCodecRejectsViolatesWellFormed() {
    drop("loss");
    drop("duplicate");
    assertThat(monitors.report().violations("datagrams.WellFormed")).isZero();
    drop("bad-payload");
    assertThat(monitors.report().violations("datagrams.WellFormed")).isEqualTo(1);
  }

  @Test
  void nothingIsRequiredOnceThereIsAnAttacker() {
    monitors.observe(new Fault(0, Fault.WORLD, Fault.BEGIN, "forge", "forge(all,5ms)"));
    drop("bad-payload");
    assertThat(monitors.report().checks("datagrams.WellFormed")).isZero();
  }
}
