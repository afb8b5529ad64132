package org.starl.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Callable;
import org.starl.launch.Attacker;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** The attacker of {@code scenarios/deployment/attack.sh}, which starts this command. */
@Command(
    name = "attack",
    hidden = true,
    description =
        "Attacks a deployment on this machine; 'scenarios/deployment/attack.sh' starts this.")
final class AttackCommand extends BaseCommand implements Callable<Integer> {

  @Parameters(index = "0", paramLabel = "PORT", description = "The first port of the deployment.")
  private int base;

  @Override
  public Integer call() throws IOException {
    try (Attacker attacker = new Attacker(base, out())) {
      attacker.run(new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8)));
    }
    return ExitStatus.GOOD;
  }
}
