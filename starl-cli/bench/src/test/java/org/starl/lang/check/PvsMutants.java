package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.starl.lang.check.Mutants.Mutant;
import org.starl.lang.pvs.PvsTheory;

/** The mutants of an automaton that {@code pvs/mutants} has: {@code pvs/check --mutants} tries them. */
final class PvsMutants {

  private static final Path PVS = Path.of("../../pvs").toAbsolutePath().normalize();

  /** The theory without a proof, the file that is changed, what is wrong, and the change. */
  private static final Pattern ENTRY = Pattern.compile("(?m)^(\\w+) (\\w+) (.*)\n +(.*)$");

  private PvsMutants() {}

  /** Those of {@code mutants} that an entry makes of the automaton's theory, by their names. */
  static List<String> of(String automaton, List<Mutant> mutants) throws IOException {
    List<String> names = new ArrayList<>();
    Matcher entry = ENTRY.matcher(Files.readString(PVS.resolve("mutants")));
    while (entry.find()) {
      for (Mutant mutant : mutants) {
        if (entry.group(2).equals(automaton) && entry.group(3).equals(mutant.toString())) {
          String theory = PvsTheory.of(mutant.automaton(), "starl/" + automaton + ".starl");
          assertThat(plain(changed(PVS.resolve(automaton + ".pvs"), entry.group(4))))
              .as("pvs/mutants, %s", mutant)
              .isEqualTo(plain(theory));
          names.add(mutant.toString());
        }
      }
    }
    return names;
  }

  private static String plain(String text) {
    return text.replaceAll("\\s+", "");
  }

  private static String changed(Path file, String sed) throws IOException {
    Process process =
        new ProcessBuilder("sed", "-e", sed, file.toString()).redirectErrorStream(true).start();
    return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
  }
}
