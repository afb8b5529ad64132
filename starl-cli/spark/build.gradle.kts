plugins {
    `java-library`
}

description = "Campaigns on Apache Spark: an engine of the command line, and the one jar for a cluster"

dependencies {
    api(project(":starl-cli"))
    // What ./starl has; nothing here is compiled against it.
    runtimeOnly(project(":starl-apps-kotlin"))
    // A cluster has it, and ./starl fetches it.
    compileOnly(libs.spark.sql)
    api(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

// Spark's, with the versions of Jackson that its module for Scala accepts.
val spark = configurations.create("spark") { extendsFrom(configurations.compileOnly.get()) }
configurations.testImplementation { extendsFrom(configurations.compileOnly.get()) }
configurations.all {
    resolutionStrategy.force(
        "com.fasterxml.jackson.core:jackson-annotations:2.21",
        "com.fasterxml.jackson.core:jackson-core:2.21.2",
        "com.fasterxml.jackson.core:jackson-databind:2.21.2",
        "com.fasterxml.jackson.dataformat:jackson-dataformat-yaml:2.21.2",
    )
}

tasks.withType<JavaCompile>().configureEach {
    // Spark's classes bear annotations that no jar has.
    options.compilerArgs.add("-Xlint:-classfile")
}

tasks.withType<Test>().configureEach {
    jvmArgs("@" + file("jvm.config").path)
}

// build/libs/starl-spark.jar: StarL with its libraries, without what Spark has. And build/spark: Spark.
val oneJar = tasks.register<Jar>("oneJar") {
    archiveFileName.set("starl-spark.jar")
    duplicatesStrategy = DuplicatesStrategy.EXCLUDE
    manifest { attributes(mapOf("Main-Class" to "org.starl.cli.Main")) }
    from(sourceSets.main.get().output)
    from(configurations.runtimeClasspath.map { files -> (files - spark).map { zipTree(it) } })
    // A signature of one library says nothing of the whole jar.
    exclude("META-INF/MANIFEST.MF", "META-INF/*.SF", "META-INF/*.RSA", "META-INF/*.DSA", "**/module-info.class")
}
tasks.register<Copy>("starlSpark") {
    dependsOn(oneJar)
    from(spark)
    into(layout.buildDirectory.dir("spark"))
}
