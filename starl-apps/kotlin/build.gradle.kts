plugins {
    application
    kotlin("jvm") version "2.3.0"
    id("maven-publish")
}

description = "Simulations described in Kotlin, and an app in Kotlin"

dependencies {
    implementation(project(":starl-core"))
    implementation(project(":starl-core-kotlin"))
    implementation(project(":starl-primitives"))
    implementation(project(":starl-sim"))
    implementation(project(":starl-sim-view"))
    implementation(project(":starl-apps"))
    implementation(project(":starl-cli-bench"))
    // Runs the app; nothing here is compiled against it.
    runtimeOnly(project(":starl-cli"))
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
    applicationName = "starl"
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
}
