package org.starl.id;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class RobotSetTest {

  private static final Participants DEPLOYMENT = Participants.of(bot(1), bot(3), bot(20), bot(100));

  private static RobotId bot(int number) {
    return new RobotId("bot" + number);
  }

  @Property(tries = 100)
  void isAsASortedSet(@ForAll List<@IntRange(min = -22, max = 22) Integer> changes) {
    RobotSet set = new RobotSet(DEPLOYMENT);
    SortedSet<RobotId> model = new TreeSet<>();
    for (int change : changes) {
      RobotId robot = bot(Math.abs(change));
      assertThat(set.contains(robot)).isEqualTo(model.contains(robot));
      if (change < 0) {
        assertThat(set.remove(robot)).isEqualTo(model.remove(robot));
      } else {
        assertThat(set.add(robot)).isEqualTo(model.add(robot));
      }
    }
    assertThat(set.sorted()).containsExactlyElementsOf(model);
    SortedSet<RobotId> missing = new TreeSet<>(DEPLOYMENT.asList());
    missing.removeAll(model);
    assertThat(set.missing()).containsExactlyElementsOf(missing);
    RobotSet both = new RobotSet(DEPLOYMENT);
    both.add(bot(7));
    both.add(bot(3));
    both.addAll(set);
    model.addAll(List.of(bot(3), bot(7)));
    assertThat(both.sorted()).containsExactlyElementsOf(model);
    both.clear();
    assertThat(both.sorted()).isEmpty();
  }

  @Test
  void setsOfOneDeploymentAreJoined() {
    RobotSet other = new RobotSet(Participants.of(bot(1)));
    assertThatThrownBy(() -> new RobotSet(DEPLOYMENT).addAll(other))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("a set in [bot1]: expected one in [bot1, bot3, bot20, bot100]");
  }
}
