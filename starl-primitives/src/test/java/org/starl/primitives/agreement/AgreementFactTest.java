package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.shape.JsonFormatException;
import org.starl.shape.Shape;
import org.starl.trace.TraceCodec;
import org.starl.trace.TraceEvent.Action;

class AgreementFactTest {

  private static final Shape<Decision<?>> DECISIONS = AgreementFact.DECIDED.shape();
  private static final RobotId A = new RobotId("a");

  @Test
  void aDecisionIsReadBackAsTheTextOfItsBytes() throws JsonFormatException {
    Value bytes = Value.write(out -> out.i64(7));
    Decision<Long> live = new Decision.Decided<>(7L, bytes);
    assertThat(DECISIONS.json(live)).isEqualTo("\"0000000000000007\"");
    Decision<?> read = OneSpelling.fromJson(DECISIONS, DECISIONS.json(live));
    assertThat(read).isEqualTo(new Decision.Decided<>("0000000000000007", bytes));
    assertThat(read).hasToString(live.toString());
  }

  @Test
  void noDecisionIsNull() throws JsonFormatException {
    assertThat(DECISIONS.json(new Decision.NoneYet<Long>())).isEqualTo("null");
    assertThat(OneSpelling.fromJson(DECISIONS, "null")).isEqualTo(new Decision.NoneYet<>());
  }

  @Test
  void whatIsNoDecisionIsRefused() {
    for (String json : List.of("\"null\"", "\"0\"", "7", "")) {
      assertThatThrownBy(() -> OneSpelling.fromJson(DECISIONS, json))
          .isInstanceOf(JsonFormatException.class);
    }
  }

  @Test
  void theFactsAreReadBack() throws JsonFormatException {
    var proposed = new AgreementAction.propose(A, "01".repeat(Value.MAX_BYTES));
    String json = AgreementFact.PROPOSE.json(proposed);
    assertThat(OneSpelling.fromJson(AgreementFact.PROPOSE, json)).isEqualTo(proposed);
    var serves = new AgreementFact.Acceptors(List.of(A, new RobotId("b")));
    json = AgreementFact.ACCEPTORS.json(serves);
    assertThat(OneSpelling.fromJson(AgreementFact.ACCEPTORS, json)).isEqualTo(serves);
    assertThat(
            TraceCodec.line(Action.of(1, A, Seen.agreement("x"), AgreementFact.ACCEPTORS, serves)))
        .contains("\"source\":\"agreement/x\",\"fact\":{\"acceptors\":{\"robots\":[\"a\",\"b\"]}}");
  }
}
