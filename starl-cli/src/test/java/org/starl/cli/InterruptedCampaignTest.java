package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A campaign that a signal stops prints what it has, and how to go on. */
@Tag("realtime")
class InterruptedCampaignTest {

  private static final Pattern LAST =
      Pattern.compile(
          "interrupted after (\\d+) of 1000000 runs; to go on: \\S+ campaign hello --seeds (\\d+)\\.\\.1000000 --threads 1");

  @ParameterizedTest
  @CsvSource({"INT, 130", "TERM, 143"})
  void theTableSoFarAndTheCommandThatGoesOnArePrinted(String signal, int status) throws Exception {
    List<String> command = new ArrayList<>(ProcessOptions.command(List.of()));
    command.remove(RobotCommand.NAME);
    command.addAll(List.of("campaign", "hello", "--seeds", "1..1000000", "--threads", "1"));
    Process campaign = new ProcessBuilder(command).start();
    try (BufferedReader err = campaign.errorReader(StandardCharsets.UTF_8);
        BufferedReader out = campaign.inputReader(StandardCharsets.UTF_8)) {
      String line = err.readLine();
      while (!line.matches("[1-9]\\d* of 1000000 runs.*")) {
        line = err.readLine();
      }
      new ProcessBuilder("kill", "-" + signal, "" + campaign.pid()).start().waitFor();
      List<String> table = out.lines().toList();
      List<String> errors = err.lines().toList();
      assertThat(campaign.waitFor()).isEqualTo(status);
      Matcher last = LAST.matcher(errors.getLast());
      assertThat(last.matches()).as("%s", errors).isTrue();
      long done = Long.parseLong(last.group(1));
      assertThat(Long.parseLong(last.group(2))).isEqualTo(done + 1);
      assertThat(table).anyMatch(row -> row.matches("runs +" + done));
      assertThat(table).anyMatch(row -> row.startsWith("bad runs: 0 of " + done + ": below "));
    }
  }
}
