package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.shape.JsonFormatException;
import org.starl.shape.RecordShape;

class BarrierFactTest {

  private static final ProcessId ID = new ProcessId(new RobotId("a"), 4294967297L);

  @Test
  void theFactsAreReadBackUnderTheirNames() throws JsonFormatException {
    check(BarrierFact.CREATED, new BarrierFact.Created(ID, Seen.ids("b.2", "a")), "Barrier");
    check(BarrierFact.ARRIVE, new BarrierAction.arrive(ID, 5), "arrive");
  }

  private static <F> void check(RecordShape<F> shape, F fact, String name)
      throws JsonFormatException {
    assertThat(OneSpelling.fromJson(shape, shape.json(fact))).isEqualTo(fact);
    assertThat(shape.name()).isEqualTo(name);
    assertThat(BarrierFact.VOCABULARY.fact(Seen.SOURCE, name)).isSameAs(shape);
  }
}
