package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.shape.JsonFormatException;
import org.starl.shape.RecordShape;

class ElectionFactTest {

  private static final ProcessId ID = new ProcessId(new RobotId("a"), 4294967297L);

  @Test
  void theFactsAreReadBackUnderTheirNames() throws JsonFormatException {
    check(ElectionFact.CREATED, new ElectionFact.Created(3, ID), "Election");
    check(ElectionFact.DO_ELECTION, new ElectionAction.do_election(ID), "do_election");
    check(ElectionFact.CANDIDATE, new ElectionAction.candidate(ID, 5), "candidate");
  }

  private static <F> void check(RecordShape<F> shape, F fact, String name)
      throws JsonFormatException {
    assertThat(OneSpelling.fromJson(shape, shape.json(fact))).isEqualTo(fact);
    assertThat(shape.name()).isEqualTo(name);
    assertThat(ElectionFact.VOCABULARY.fact(Seen.SOURCE, name)).isSameAs(shape);
  }
}
