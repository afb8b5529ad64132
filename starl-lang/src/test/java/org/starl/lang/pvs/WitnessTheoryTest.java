package org.starl.lang.pvs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

/** The theories {@code pvs/NAME_witness.pvs}; of the intersection it is {@code intersection_run}. */
class WitnessTheoryTest {

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Mutex_decls",
        "Mutex_group_decls",
        "MutexProtocol_decls",
        "Pipeline_decls",
        "Modes_decls",
        "Registration_decls",
        "SetAgreement_decls",
        "Election_decls",
        "Barrier_decls",
        "Ledger_decls",
        "Geocast_decls",
        "MotionControl_decls",
        "IcpProgram"
      })
  void keptTheoryHasARunToEachAction(String source) throws IOException, SourceErrors {
    Path pvs = Path.of("../pvs").toAbsolutePath().normalize();
    boolean isProgram = !source.endsWith("_decls");
    String from = (isProgram ? "../starl-apps/src/main/starl/" : "starl/") + source + ".starl";
    Automaton automaton = new SourceReader().read(pvs.resolve(from).normalize()).getLast();
    String name = WitnessTheory.nameOf(automaton) + ".pvs";
    Path made = Files.createDirectories(Path.of("target/pvs")).resolve(name);
    Files.writeString(made, WitnessTheory.of(automaton, from));
    assertThat(pvs.resolve(name)).hasSameTextualContentAs(made);
  }
}
