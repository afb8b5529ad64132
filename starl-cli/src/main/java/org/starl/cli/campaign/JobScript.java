package org.starl.cli.campaign;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.starl.Version;
import org.starl.cli.command.Shell;

/** A job for a cluster's scheduler that runs each shard of a campaign. */
final class JobScript {

  /** The scheduler. */
  enum Scheduler {
    KUBERNETES,
    SLURM
  }

  private static final int MAX_NAME = 40;

  private JobScript() {}

  /**
   * The text of the job.
   *
   * @param words of the campaign's command line, after the launcher
   */
  static String of(Scheduler scheduler, String app, List<String> words, int shards) {
    String lower = app.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
    String name = "starl-" + lower.substring(0, Math.min(lower.length(), MAX_NAME));
    String job = name.replaceAll("-+$", "");
    return switch (scheduler) {
      case KUBERNETES -> kubernetes(job, words, shards);
      case SLURM -> slurm(job, words, shards);
    };
  }

  /** An Indexed Job, whose indices begin at 0. */
  private static String kubernetes(String name, List<String> words, int shards) {
    // Kubernetes replaces $(NAME) in arguments, and $$ by $.
    String command = quoted(words).replace("$", "$$").replace("\n", "\n              ");
    return """
    # Each pod runs one shard, with the image of docs/Containerfile, and writes to one volume.
    # Afterwards, where the volume is mounted: starl merge /shards/part-*
    apiVersion: batch/v1
    kind: Job
    metadata:
      name: %1$s
    spec:
      completions: %2$d
      parallelism: %2$d
      completionMode: Indexed
      backoffLimitPerIndex: 3
      template:
        spec:
          restartPolicy: Never
          containers:
            - name: starl
              image: starl:%3$s
              command: ["/bin/sh", "-c"]
              args:
                - |
                  part=$((JOB_COMPLETION_INDEX + 1))
                  exec starl %4$s \\
                    --shard "$part/%2$d" --out "/shards/part-$part" --resume --threads 1
              resources:
                requests:
                  cpu: "1"
                  memory: 1Gi
              volumeMounts:
                - name: shards
                  mountPath: /shards
          volumes:
            - name: shards
              persistentVolumeClaim:
                claimName: starl-shards
    """
        .formatted(name, shards, Version.STARL, command);
  }

  private static String slurm(String name, List<String> words, int shards) {
    return """
    #!/bin/sh
    # Each task of the array runs one shard. Afterwards: %4$s merge part-*
    #SBATCH --job-name=%1$s
    #SBATCH --array=1-%2$d
    #SBATCH --cpus-per-task=1
    #SBATCH --output=%1$s-%%A-%%a.log
    exec %4$s %3$s \\
      --shard "$SLURM_ARRAY_TASK_ID/%2$d" --out "part-$SLURM_ARRAY_TASK_ID" --resume --threads 1
    """
        .formatted(name, shards, quoted(words), Shell.launcher());
  }

  private static String quoted(List<String> words) {
    return words.stream().map(Shell::quote).collect(Collectors.joining(" "));
  }
}
