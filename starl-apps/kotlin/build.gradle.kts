plugins {
    application
    kotlin("jvm") version "2.3.0"
    id("maven-publish")
}

group = "org.starl"
version = "0.1.0-SNAPSHOT"
description = "Simulations described in Kotlin, and an app in Kotlin"

dependencies {
    implementation("org.starl:starl-core:0.1.0-SNAPSHOT")
    implementation("org.starl:starl-primitives:0.1.0-SNAPSHOT")
    implementation("org.starl:starl-sim:0.1.0-SNAPSHOT")
    implementation("org.starl:starl-apps:0.1.0-SNAPSHOT")
    implementation(libs.kotlin.stdlib)
    implementation(libs.jspecify)
    // Compiles what `starl new` writes.
    testImplementation(libs.kotlin.compiler.embeddable)
    testImplementation(libs.junit.platform.testkit)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

application {
    mainClass.set("org.starl.cli.Main")
    // The simulator schedules virtual threads itself; java.lang must be open for that.
    applicationDefaultJvmArgs = listOf("--add-opens", "java.base/java.lang=ALL-UNNAMED")
}

kotlin {
    compilerOptions {
        jvmTarget.set(org.jetbrains.kotlin.gradle.dsl.JvmTarget.JVM_21)
        allWarningsAsErrors.set(true)
        freeCompilerArgs.add("-Xjdk-release=21")
    }
}

java {
    targetCompatibility = JavaVersion.VERSION_21
    withSourcesJar()
}

publishing {
    publications.create("maven", MavenPublication::class.java) {
        from(components["java"])
    }
}

tasks.withType<Test>().configureEach {
    useJUnitPlatform()
    // The simulator's carriers need java.lang; libraries under test may load agents.
    jvmArgs("--add-opens", "java.base/java.lang=ALL-UNNAMED", "-XX:+EnableDynamicAgentLoading")
    systemProperty("java.awt.headless", "true")
    systemProperty("slf4j.internal.verbosity", "ERROR")
}
