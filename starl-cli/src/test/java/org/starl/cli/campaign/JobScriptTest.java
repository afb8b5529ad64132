package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.dataformat.yaml.YAMLMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.cli.Cli;

/** {@code starl campaign --print-job}. */
class JobScriptTest {

  private static final List<String> CAMPAIGN =
      List.of("campaign", "hello", "--seeds", "1..500", "--fault", "stuck(any,at=1s)");

  @TempDir private Path folder;

  private static Cli print(String... more) {
    String[] words = Stream.concat(CAMPAIGN.stream(), Stream.of(more)).toArray(String[]::new);
    Cli cli = Cli.run(words);
    assertThat(cli.status()).as("%s", cli).isZero();
    return cli;
  }

  /** Runs a script with a command {@code starl} that prints its words, one a line. */
  private List<String> words(String script, Map<String, String> environment)
      throws IOException, InterruptedException {
    Path starl = folder.resolve("starl");
    Files.writeString(starl, "#!/bin/sh\nprintf '%s\\n' \"$@\"\n");
    assertThat(starl.toFile().setExecutable(true)).isTrue();
    ProcessBuilder builder = new ProcessBuilder("/bin/sh", "-c", script).directory(folder.toFile());
    builder.environment().putAll(environment);
    builder.environment().merge("PATH", folder.toString(), (old, mine) -> mine + ":" + old);
    Process process = builder.redirectErrorStream(true).start();
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(out).isZero();
    return out.lines().toList();
  }

  private static List<String> shard(String number, String file) {
    return Stream.concat(
            CAMPAIGN.stream(),
            Stream.of("--shard", number + "/50", "--out", file, "--resume", "--threads", "1"))
        .toList();
  }

  private static JsonNode job(Cli cli) throws IOException {
    return new YAMLMapper().readTree(cli.text());
  }

  @Test
  void theJobForKubernetesHasAnIndexForEachShard() throws IOException {
    JsonNode job = job(print("--print-job", "kubernetes", "--shards", "50"));
    assertThat(job.at("/apiVersion").asText()).isEqualTo("batch/v1");
    assertThat(job.at("/metadata/name").asText()).isEqualTo("starl-hello");
    assertThat(job.at("/spec/completionMode").asText()).isEqualTo("Indexed");
    assertThat(job.at("/spec/completions").asInt()).isEqualTo(50);
  }

  @Test
  @Tag("realtime")
  void aPodRunsItsShard() throws IOException, InterruptedException {
    JsonNode job = job(print("--print-job", "kubernetes", "--shards=50"));
    String script = job.at("/spec/template/spec/containers/0/args/0").asText();
    assertThat(words(script, Map.of("JOB_COMPLETION_INDEX", "6")))
        .isEqualTo(shard("7", "/shards/part-7"));
  }

  @Test
  @Tag("realtime")
  void aTaskOfSlurmRunsItsShard() throws IOException, InterruptedException {
    Cli cli = print("--threads", "3", "--print-job", "slurm", "--shards", "50");
    assertThat(cli.out()).startsWith("#!/bin/sh").contains("#SBATCH --array=1-50");
    assertThat(words(cli.text(), Map.of("SLURM_ARRAY_TASK_ID", "7")))
        .isEqualTo(shard("7", "part-7"));
  }
}
