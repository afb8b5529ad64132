package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Variable;

class KillTest {

  private static final RobotId BOT2 = new RobotId("bot2");

  @ParameterizedTest
  @ValueSource(
      strings = {
        "bot2@12s",
        "bot2@app.location=MOVE_WAIT",
        "bot2@app.location=MOVE_WAIT+1500ms",
        "bot2@mutex/crossing.crit=true+1s"
      })
  void itIsWrittenAsItWasRead(String text) {
    assertThat(Kill.parse(text)).hasToString(text);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"bot2", "@2s", "bot2@", "bot2@soon", "bot2@location=X", "bot2@a.b=c+soon"})
  void otherTextIsRefused(String text) {
    assertThatThrownBy(() -> Kill.parse(text)).isInstanceOf(BadInput.class);
  }

  private static Variable ahead(RobotId robot, String... zones) {
    return new Variable(5, robot, Instance.APP, CrossingFact.MYSEQ, List.of(zones));
  }

  @Test
  void itsVariableTriggersIt() {
    Kill kill = Kill.parse("bot2@app.myseq=[C, C1]+1s");
    assertThat(kill.afterNs()).isEqualTo(1_000_000_000);
    assertThat(kill.isTriggeredBy(ahead(BOT2, "C", "C1"))).isTrue();
    assertThat(kill.isTriggeredBy(ahead(BOT2, "C1"))).isFalse();
    assertThat(kill.isTriggeredBy(ahead(new RobotId("bot1"), "C", "C1"))).isFalse();
    assertThat(Kill.parse("bot2@1s").isTriggeredBy(ahead(BOT2))).isFalse();
  }
}
