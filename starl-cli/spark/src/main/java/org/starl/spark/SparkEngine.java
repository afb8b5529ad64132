package org.starl.spark;

import java.io.IOException;
import java.security.CodeSource;
import java.util.List;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaRDD;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.sql.SparkSession;
import org.apache.spark.storage.StorageLevel;
import org.jspecify.annotations.Nullable;
import org.starl.cli.campaign.CampaignEngine;
import org.starl.cli.campaign.SeedPart;
import org.starl.input.BadInput;

/** Spark, on this machine ({@code --on spark}) or on a cluster ({@code --on spark=MASTER}). */
public final class SparkEngine implements CampaignEngine {

  /** The simulator schedules virtual threads itself; java.lang must be open for that. */
  private static final String JVM_OPTIONS =
      "--add-opens=java.base/java.lang=ALL-UNNAMED --enable-native-access=ALL-UNNAMED";

  private static final String EXECUTOR_OPTIONS = "spark.executor.extraJavaOptions";

  @Override
  public String name() {
    return "spark";
  }

  @Override
  public void run(String master, int cores, SeedPart campaign, @Nullable String parquet, Rows rows)
      throws InterruptedException, IOException {
    SparkConf conf = conf(master, cores);
    if (parquet != null) {
      ParquetFolder.requireNew(parquet);
    }
    try (SparkSession session = session(conf)) {
      JavaSparkContext spark = JavaSparkContext.fromSparkContext(session.sparkContext());
      List<SeedPart> parts = campaign.split(spark.defaultParallelism());
      JavaRDD<List<String>> lines = spark.parallelize(parts, parts.size()).map(SeedPart::run);
      if (parquet == null) {
        new PartsJob(lines, parts).run(rows);
        return;
      }
      lines.persist(StorageLevel.DISK_ONLY());
      ParquetFolder folder = new ParquetFolder(rows);
      new PartsJob(lines, parts).run(folder);
      folder.write(session, lines, parts, parquet);
    }
  }

  /** What {@code spark-submit} gives takes precedence, but for the master of {@code --on}. */
  static SparkConf conf(String master, int cores) {
    SparkConf conf = new SparkConf().setAppName("starl campaign");
    if (!master.isEmpty()) {
      conf.setMaster(master);
    } else if (!conf.contains("spark.master")) {
      conf.setMaster("local[" + cores + "]")
          .set("spark.driver.host", "localhost")
          .set("spark.driver.bindAddress", "127.0.0.1");
    }
    conf.setIfMissing("spark.ui.enabled", "false");
    conf.setIfMissing("spark.log.level", "ERROR");
    // A million rows are gigabytes; they are taken one part at a time.
    conf.setIfMissing("spark.driver.maxResultSize", "0");
    conf.set(EXECUTOR_OPTIONS, (conf.get(EXECUTOR_OPTIONS, "") + " " + JVM_OPTIONS).stripLeading());
    CodeSource source = SeedPart.class.getProtectionDomain().getCodeSource();
    if (source != null && source.getLocation().getPath().endsWith(".jar")) {
      conf.setIfMissing("spark.jars", source.getLocation().toString());
    }
    return conf;
  }

  private static SparkSession session(SparkConf conf) {
    try {
      return SparkSession.builder().config(conf).getOrCreate();
    } catch (Exception e) { // methods of Scala do not declare what they throw
      throw new BadInput(
          "--on: %s: cannot be used (%s); expected a master such as spark://host:7077"
              .formatted(BadInput.quote(conf.get("spark.master")), firstLine(e)));
    }
  }

  /** The first line of what Spark says. */
  static IOException failed(Throwable cause) {
    return new IOException("--on spark: " + firstLine(cause), cause);
  }

  private static String firstLine(Throwable error) {
    return String.valueOf(error.getMessage()).split("\n", 2)[0];
  }
}
