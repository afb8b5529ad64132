package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.statistics.Statistics;
import org.starl.primitives.Phases;
import org.starl.primitives.mutex.MutexWorld.Shape;
import org.starl.primitives.mutex.MutexWorld.ViewFault;
import org.starl.trace.TraceEvent;

/** The phases that a trace shows are those of the protocol. */
class MutexPhasesTest {

  private static final Shape HARSH = new Shape(3, 3, 3, 2, 4, ViewFault.NONE);

  @Property(tries = 50)
  void aTraceShowsTheProtocolsPhase(@ForAll long seed) {
    MutexWorld world = new MutexWorld(HARSH, MutexProtocol::new, seed);
    Map<String, String> shown = new TreeMap<>();
    Set<String> seen = new TreeSet<>();
    Phases.Step step = MutexFact.PHASES.steps().get();
    int read = 0;
    for (int i = 0; i < 400; i++) {
      world.run(1);
      for (; read < world.trace.size(); read++) {
        TraceEvent.Action event = world.trace.get(read);
        String id = String.valueOf(event.process());
        String before = shown.getOrDefault(id, MutexFact.PHASES.first());
        shown.put(id, step.after(before, event));
        seen.add(shown.get(id));
      }
      for (MutexNode node : world.nodes) {
        assertThat(shown.getOrDefault(node.id.toString(), MutexFact.PHASES.first()))
            .as("%s after step %d", node.id, i)
            .isEqualTo(node.protocol.phase().name());
      }
    }
    Statistics.collect(seen.containsAll(MutexFact.PHASES.names()));
    Statistics.coverage(runs -> runs.check(true).percentage(share -> share > 50));
  }
}
